#include "report/csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace amalgam::report {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Csv, OnlyWhatNeedsQuotesHasThem) {
  EXPECT_EQ(csv_line({"plain", "", "a,b", "say \"so\"", "two\nlines"}),
            "plain,,\"a,b\",\"say \"\"so\"\"\",\"two\nlines\"\n");
}

TEST(Csv, ReadsWhatItWrites) {
  const CsvRow row{"a,b", "\"", "", "x\ny\r\n", "\"\",\"", "end"};
  const CsvText text = parse_csv(csv_line(row) + csv_line(row));
  EXPECT_THAT(text.rows, ElementsAre(row, row));
  EXPECT_EQ(text.whole_size, 2 * csv_line(row).size());
}

// Wherever the text is cut: whole rows stay, and nothing of the half one.
TEST(Csv, AHalfRowIsNone) {
  const std::string first = csv_line({"1", "2"}), second = csv_line({"a\nb", "say \"\n\""});
  const std::string both = first + second;
  for (std::size_t size = first.size(); size < both.size(); ++size) {
    const CsvText text = parse_csv(both.substr(0, size));
    EXPECT_THAT(text.rows, ElementsAre(CsvRow{"1", "2"})) << size;
    EXPECT_EQ(text.whole_size, first.size()) << size;
  }
  EXPECT_THAT(parse_csv("").rows, IsEmpty());
}

TEST(Csv, NumbersComeBackToTheBit) {
  for (const double value : {0.1, 1.0 / 3.0, -0.0, 1e-300, 5e-324, 123456789.0,
                             std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(parse_csv_number(csv_number(value)), value) << value;
  }
  EXPECT_EQ(csv_number(0.1), "0.1");
  for (const char* none : {"", "x", "1x", " 1", "nan"}) {
    EXPECT_TRUE(std::isnan(parse_csv_number(none))) << none;
  }
}

}  // namespace
}  // namespace amalgam::report
