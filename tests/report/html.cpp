#include "report/html.h"

#include <openssl/evp.h>

#include <cmath>
#include <cstdio>

namespace amalgam::report {
namespace {

std::string base64(const std::string& bytes) {
  std::string encoded(4 * ((bytes.size() + 2) / 3) + 1, '\0');  // and the end that OpenSSL writes
  const int size = EVP_EncodeBlock(reinterpret_cast<unsigned char*>(encoded.data()),
                                   reinterpret_cast<const unsigned char*>(bytes.data()),
                                   static_cast<int>(bytes.size()));
  encoded.resize(static_cast<std::size_t>(size));
  return encoded;
}

}  // namespace

Html text(std::string_view plain) {
  Html html;
  for (const char c : plain) {
    switch (c) {
      case '&':
        html.markup += "&amp;";
        break;
      case '<':
        html.markup += "&lt;";
        break;
      case '>':
        html.markup += "&gt;";
        break;
      case '"':
        html.markup += "&quot;";
        break;
      case '\'':
        html.markup += "&#39;";
        break;
      default:
        html.markup += c;
    }
  }
  return html;
}

Html element(const std::string& name, const Html& content) {
  return {"<" + name + ">" + content.markup + "</" + name + ">\n"};
}

Html element(const std::string& name, std::string_view plain) {
  return element(name, text(plain));
}

Html element(const std::string& name, const std::string& css_class, const Html& content) {
  return {"<" + name + " class=\"" + text(css_class).markup + "\">" + content.markup + "</" + name +
          ">\n"};
}

Html table(const std::vector<std::string>& head, const std::vector<std::vector<Html>>& rows,
           std::size_t first_number) {
  const auto cell = [&](const std::string& name, std::size_t column, const Html& content) {
    return column < first_number ? element(name, content) : element(name, "number", content);
  };
  Html heads, body;
  for (std::size_t i = 0; i < head.size(); ++i) heads += cell("th", i, text(head[i]));
  for (const auto& row : rows) {
    Html cells;
    for (std::size_t i = 0; i < row.size(); ++i) cells += cell("td", i, row[i]);
    body += element("tr", cells);
  }
  // Wide tables scroll on their own on narrow screens.
  return element("div", "scroll",
                 element("table", element("thead", element("tr", heads)) + element("tbody", body)));
}

Html png_image(const std::string& png, std::string_view description) {
  return {"<img src=\"data:image/png;base64," + base64(png) + "\" alt=\"" +
          text(description).markup + "\">"};
}

Html number(double value) {
  if (std::isnan(value)) return text("-");
  char shown[32];
  std::snprintf(shown, sizeof shown, "%.3g", value);
  return text(shown);
}

}  // namespace amalgam::report
