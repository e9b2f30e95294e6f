# Which versions may be asked for by find_package(Urbi VERSION): those from the beginning of this major version on.
set(PACKAGE_VERSION "3.0.0")
string(REGEX MATCH "^[0-9]+" _urbi_major "${PACKAGE_VERSION}")
if(PACKAGE_FIND_VERSION_MAJOR EQUAL _urbi_major AND NOT PACKAGE_VERSION VERSION_LESS PACKAGE_FIND_VERSION)
  set(PACKAGE_VERSION_COMPATIBLE TRUE)
  if(PACKAGE_FIND_VERSION VERSION_EQUAL PACKAGE_VERSION)
    set(PACKAGE_VERSION_EXACT TRUE)
  endif()
endif()
