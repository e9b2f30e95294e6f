/// What clients that were written before 2.0 include.
#ifndef LIBURBI_COMPATIBILITY_HH
#define LIBURBI_COMPATIBILITY_HH

#include <urbi/uclient.hh>
#include <urbi/usyncclient.hh>

#endif
