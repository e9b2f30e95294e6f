/// Defines WIN32 where Windows is.
#ifndef LIBPORT_DETECT_WIN32_H
#define LIBPORT_DETECT_WIN32_H

#if defined _WIN32 && !defined WIN32
#define WIN32
#endif

#endif
