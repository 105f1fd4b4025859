#include "protocol/session_record.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "protocol/framing.h"
#include "support/record_folder.h"

namespace amalgam::protocol {
namespace {

std::string header() {
  SessionRecord record;
  record.mutable_header()->set_format(kRecordFormat);
  record.mutable_header()->set_session(3);
  return encode(record);
}

std::string written(std::uint64_t frame) {
  SessionRecord record;
  record.set_time_us(1000 * frame);
  record.mutable_written()->set_frame(frame);
  return encode(record);
}

class SessionRecordTest : public testing::Test {
 protected:
  std::filesystem::path file_with(const std::string& bytes) {
    const std::filesystem::path path = folder_.path() / "a.session";
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
  }
  test::RecordFolder folder_;
};

// As by kill -9: whatever was written whole is read.
TEST_F(SessionRecordTest, IsReadUpToWhereItWasCut) {
  const std::string first = header() + written(1), whole = first + written(2);
  for (std::size_t size = header().size(); size <= whole.size(); ++size) {
    SessionRecordReader reader(file_with(whole.substr(0, size)));
    EXPECT_EQ(reader.header().session(), 3u);
    std::size_t count = 0;
    while (const auto record = reader.next()) EXPECT_EQ(record->written().frame(), ++count);
    EXPECT_EQ(count, (size >= first.size()) + (size == whole.size())) << size;
    EXPECT_EQ(reader.was_cut(),
              size != header().size() && size != first.size() && size != whole.size())
        << size;
  }
}

TEST_F(SessionRecordTest, RefusesWhatIsNone) {
  const auto open = [this](const std::string& bytes) { SessionRecordReader(file_with(bytes)); };
  EXPECT_THROW(open(""), std::runtime_error);
  EXPECT_THROW(open("{\"asset\": {\"version\": \"2.0\"}}"), std::runtime_error);
  EXPECT_THROW(open(written(1)), std::runtime_error);
  SessionRecord future;
  future.mutable_header()->set_format(kRecordFormat + 1);
  EXPECT_THROW(open(encode(future)), std::runtime_error);
  EXPECT_THROW(SessionRecordReader(folder_.path() / "none"), std::runtime_error);
  EXPECT_THROW(SessionRecordReader{folder_.path()}, std::runtime_error);
}

TEST_F(SessionRecordTest, SaysWhereItIsDamaged) {
  for (const std::string& damage : {std::string(8, '\0'), std::string("\x02\0\0\0\xff\xff", 6),
                                    std::string("\xff\xff\xff\xff", 4)}) {
    SessionRecordReader reader(file_with(header() + written(1) + damage));
    EXPECT_TRUE(reader.next());
    try {
      reader.next();
      ADD_FAILURE() << "no error";
    } catch (const std::runtime_error& error) {
      const std::string at = std::to_string(header().size() + written(1).size());
      EXPECT_NE(std::string(error.what()).find("byte " + at), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace amalgam::protocol
