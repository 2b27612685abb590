#include "wrcontact.h"

extern "C" {

const char* wrc_status_name(wrc_status status) {
  switch (status) {
  case WRC_OK:
    return "ok";
  case WRC_INVALID_ARGUMENT:
    return "invalid argument";
  case WRC_UNKNOWN_NAME:
    return "unknown name";
  case WRC_FILE_UNREADABLE:
    return "file unreadable";
  case WRC_FILE_MALFORMED:
    return "file malformed";
  case WRC_NO_CONTACT:
    return "no contact";
  case WRC_OUT_OF_MEMORY:
    return "out of memory";
  case WRC_INTERNAL:
    return "internal fault";
  case WRC_NOT_CONVERGED:
    return "not converged";
  case WRC_TOO_SMALL:
    return "array too small";
  case WRC_NO_RESULT:
    return "no result";
  case WRC_BUSY:
    return "handle in use";
  default:
    return "unknown status";
  }
}

const char* wrc_version(void) {
  return WRC_VERSION_TEXT;
}
}
