/// The headers of Windows, and nothing elsewhere.
#ifndef LIBPORT_WINDOWS_HH
#define LIBPORT_WINDOWS_HH

#include <libport/detect-win32.h>

#ifdef WIN32
#include <windows.h>
#endif

#endif
