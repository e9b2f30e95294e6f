/// The version of these headers.
#ifndef URBI_REVISION_HH
#define URBI_REVISION_HH

#define URBI_SDK_VERSION "2.7.5"
#define URBI_SDK_REVISION "boundary-2"

#endif
