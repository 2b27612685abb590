#include "support/checksum.hpp"

#include <array>
#include <iomanip>
#include <sstream>

#include <openssl/evp.h>

#include "support/scene.hpp"

namespace driver {

std::string sha256_of(const std::string& name, const std::string& content) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned size = 0;
  if (EVP_Digest(content.data(), content.size(), digest.data(), &size, EVP_sha256(), nullptr) !=
      1) {
    throw Failure("no SHA-256 sum of " + name);
  }
  std::ostringstream text;
  text << std::hex << std::setfill('0');
  for (unsigned i = 0; i < size; ++i) {
    text << std::setw(2) << static_cast<int>(digest[i]);
  }
  return text.str();
}

} // namespace driver
