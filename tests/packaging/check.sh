#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# check.sh find_package|add_subdirectory CMAKE SOURCE BUILD COMPILER BUILD_TYPE FLAGS
# Builds and runs tests/packaging/consumer and the C++ program of README.md against eliminant, installed from the build
# tree BUILD into a prefix of its own; or compiles them with eliminant taken in as a subdirectory. To link them there
# would compile the whole library a second time, with the targets that find_package has already linked.
set -euo pipefail

way=$1 cmake=$2 source=$3 build=$4 compiler=$5 build_type=$6 flags=$7
work=$build/packaging/$way
consumer=("$cmake" -S "$source/tests/packaging/consumer" -B "$work/build" -G Ninja "-DCMAKE_CXX_COMPILER=$compiler"
  "-DREADME_PROGRAM=$work/readme.cpp")

case $way in
  find_package)
    rm -rf "$work"
    "$cmake" --install "$build" --prefix "$work/prefix" >/dev/null
    # No installed file may lead back into the source or build tree.
    if grep -rlF -e "$source/" -e "$build/" "$work/prefix" --include='*.cmake' --include='*.hpp'; then
      echo "the files above name the source or build tree" >&2
      exit 1
    fi
    consumer+=("-DCMAKE_PREFIX_PATH=$work/prefix" "-DCMAKE_BUILD_TYPE=$build_type" "-DCMAKE_CXX_FLAGS=$flags")
    ;;
  add_subdirectory)
    consumer+=("-DELIMINANT_SOURCE=$source" -DCMAKE_BUILD_TYPE=Debug "-DCMAKE_CXX_FLAGS=$flags")
    ;;
  *)
    echo "unknown way: $way" >&2
    exit 1
    ;;
esac
mkdir -p "$work"
perl -0ne 'print $1 if /```cpp\n(.*?)```/s' "$source/README.md" >"$work/readme.cpp.new"
if ! cmp -s "$work/readme.cpp.new" "$work/readme.cpp"; then cp "$work/readme.cpp.new" "$work/readme.cpp"; fi
perl -0ne 'print $1 if /```cpp\n.*?```\n\n```text\n(.*?)```/s' "$source/README.md" >"$work/readme.expected"

"${consumer[@]}"
if [ "$way" = add_subdirectory ]; then
  exec "$cmake" --build "$work/build" --parallel 2 --target consumer_objects readme_objects
fi
"$cmake" --build "$work/build" --parallel 2 --target consumer readme
"$work/build/consumer"
"$work/build/readme" | diff "$work/readme.expected" -
