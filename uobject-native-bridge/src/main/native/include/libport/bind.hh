/// Functions with some of their arguments given. Where Boost is installed, it is its own.
#ifndef LIBPORT_BIND_HH
#define LIBPORT_BIND_HH

#include <functional>

#include <libport/boost-names.hh>

#if defined __has_include && __has_include(<boost/bind.hpp>)
#define BOOST_BIND_GLOBAL_PLACEHOLDERS
#include <boost/bind.hpp>
#else
using namespace std::placeholders;
#endif

#endif
