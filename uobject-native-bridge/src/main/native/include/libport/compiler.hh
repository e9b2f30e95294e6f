/// What compilers are told beside the language.
#ifndef LIBPORT_COMPILER_HH
#define LIBPORT_COMPILER_HH

#include <libport/preproc.hh>

#if defined __GNUC__
#define ATTRIBUTE_ALWAYS_INLINE __attribute__((always_inline))
#define ATTRIBUTE_CONST __attribute__((const))
#define ATTRIBUTE_DEPRECATED __attribute__((deprecated))
#define ATTRIBUTE_MALLOC __attribute__((malloc))
#define ATTRIBUTE_NOINLINE __attribute__((noinline))
#define ATTRIBUTE_NORETURN __attribute__((noreturn))
#define ATTRIBUTE_PRINTF(Format, First) __attribute__((format(printf, Format, First)))
#define ATTRIBUTE_PURE __attribute__((pure))
#define ATTRIBUTE_UNUSED __attribute__((unused))
#define ATTRIBUTE_UNUSED_RESULT __attribute__((warn_unused_result))
#define LIBPORT_SPEED_ALWAYS_INLINE inline __attribute__((always_inline))
#define LIBPORT_LIKELY(Condition) __builtin_expect(!!(Condition), 1)
#define LIBPORT_UNLIKELY(Condition) __builtin_expect(!!(Condition), 0)
#else
#define ATTRIBUTE_ALWAYS_INLINE
#define ATTRIBUTE_CONST
#define ATTRIBUTE_DEPRECATED
#define ATTRIBUTE_MALLOC
#define ATTRIBUTE_NOINLINE
#define ATTRIBUTE_NORETURN [[noreturn]]
#define ATTRIBUTE_PRINTF(Format, First)
#define ATTRIBUTE_PURE
#define ATTRIBUTE_UNUSED
#define ATTRIBUTE_UNUSED_RESULT
#define LIBPORT_SPEED_ALWAYS_INLINE inline
#define LIBPORT_LIKELY(Condition) (Condition)
#define LIBPORT_UNLIKELY(Condition) (Condition)
#endif

/// A function whose static variables each module has of its own: others would keep it loaded.
#if defined __GNUC__ && !defined _WIN32
#define LIBPORT_LOCAL __attribute__((visibility("hidden")))
#else
#define LIBPORT_LOCAL
#endif

#define ATTRIBUTE_DLLEXPORT
#define ATTRIBUTE_DLLIMPORT
#define ATTRIBUTE_NOTHROW throw()

/// Says that variables are used, where a compiler cannot see it.
#if __cplusplus >= 201103L
namespace libport
{
  namespace detail
  {
    template <typename... T>
    inline void use(const T&...)
    {}
  }
}
#define LIBPORT_USE(...) ::libport::detail::use(__VA_ARGS__)
#else
#define LIBPORT_USE(...) static_cast<void>(0)
#endif

#endif
