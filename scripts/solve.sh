#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# solve.sh [FILE] [OPTION...]
# Installs what is missing, builds the program where that is needed, and solves the problem in FILE (default: example 4
# of the paper that the method for plane curves comes from). Options are those of `eliminant solve`.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)

"$here/setup.sh"
"$here/build.sh" release eliminant
if [ $# -eq 0 ]; then set -- "$here/../examples/paper_example_4.json"; fi
exec "$here/../build/release/eliminant" solve "$@"
