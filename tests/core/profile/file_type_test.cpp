// What extensions say of files.
#include "profile/file_type.hpp"

#include <gtest/gtest.h>

namespace wrc::test::file_type_test {
namespace {

void expect_type(const char* path, ProfileFormat format, std::optional<ProfileKind> kind) {
  const FileType type = type_of(path);
  EXPECT_EQ(type.format, format) << path;
  EXPECT_EQ(type.kind, kind) << path;
}

TEST(FileType, IsThatOfTheExtension) {
  expect_type("worn.prr", ProfileFormat::simpack, ProfileKind::rail);
  expect_type("worn.prw", ProfileFormat::simpack, ProfileKind::wheel);
  expect_type("worn.ban", ProfileFormat::miniprof, ProfileKind::rail);
  expect_type("worn.whl", ProfileFormat::miniprof, ProfileKind::wheel);
  expect_type("worn.slcs", ProfileFormat::slices, ProfileKind::rail);
  expect_type("worn.slcw", ProfileFormat::slices, ProfileKind::wheel);
  expect_type("worn.rail", ProfileFormat::columns, ProfileKind::rail);
  expect_type("worn.wheel", ProfileFormat::columns, ProfileKind::wheel);
}

TEST(FileType, CapitalsAndFoldersChangeNothing) {
  expect_type("a.prr/B.PRW", ProfileFormat::simpack, ProfileKind::wheel);
  expect_type("a.whl/b.Ban", ProfileFormat::miniprof, ProfileKind::rail);
}

TEST(FileType, OtherFilesAreColumnsOfEitherKind) {
  for (const char* path : {"worn.txt", "worn", "prr", "worn.prr.csv", "worn.prrx"}) {
    expect_type(path, ProfileFormat::columns, std::nullopt);
  }
}

} // namespace
} // namespace wrc::test::file_type_test
