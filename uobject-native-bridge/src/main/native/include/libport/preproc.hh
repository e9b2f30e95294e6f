/// Macros that make names and texts.
#ifndef LIBPORT_PREPROC_HH
#define LIBPORT_PREPROC_HH

#define LIBPORT_CAT(A, B) LIBPORT_CAT_(A, B)
#define LIBPORT_CAT_(A, B) A##B

#define LIBPORT_STRINGIZE(...) LIBPORT_STRINGIZE_(__VA_ARGS__)
#define LIBPORT_STRINGIZE_(...) #__VA_ARGS__

/// A name that no other line has.
#define LIBPORT_UNIQUE(Name) LIBPORT_CAT(Name, __LINE__)

#endif
