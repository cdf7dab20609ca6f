// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/pictures/html_report.hpp>

#include <eliminant/io/pictures/svg_picture.hpp>

namespace eliminant::io {

namespace {

constexpr const char* style =
    "body{font-family:sans-serif;margin:2em;color:#222}svg{max-width:100%;height:auto}"
    "table{border-collapse:collapse;margin:0.5em 0 1.5em}caption{text-align:left;font-weight:bold;padding:0.3em 0}"
    "th,td{padding:0.2em 0.8em;border-bottom:1px solid #ddd;text-align:left;font-variant-numeric:tabular-nums}";

std::string row(const std::vector<std::string>& cells, const std::string& tag) {
  std::string out = "<tr>";
  for (const std::string& cell : cells) out += "<" + tag + ">" + escaped(cell) + "</" + tag + ">";
  return out + "</tr>\n";
}

}  // namespace

std::string html_report(const Picture& picture) {
  std::string out = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>" +
                    escaped(picture.title) + "</title>\n<style>" + style + "</style>\n</head>\n<body>\n";
  out += svg_picture(picture);
  for (const PictureTable& table : picture.tables) {
    if (table.rows.empty()) continue;
    out += "<table>\n<caption>" + escaped(table.title) + "</caption>\n" + row(table.header, "th");
    for (const auto& cells : table.rows) out += row(cells, "td");
    out += "</table>\n";
  }
  return out + "</body>\n</html>\n";
}

}  // namespace eliminant::io
