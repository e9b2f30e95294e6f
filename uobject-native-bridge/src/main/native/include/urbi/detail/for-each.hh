/// Applies a macro to each of up to 32 arguments: M(Data, argument).
#ifndef URBI_DETAIL_FOR_EACH_HH
#define URBI_DETAIL_FOR_EACH_HH

#define URBI_FOR_EACH(M, Data, ...)                                                               \
  URBI_FE_PICK_(__VA_ARGS__,                                                                      \
    URBI_FE_32_, URBI_FE_31_, URBI_FE_30_, URBI_FE_29_, URBI_FE_28_, URBI_FE_27_,                 \
    URBI_FE_26_, URBI_FE_25_, URBI_FE_24_, URBI_FE_23_, URBI_FE_22_, URBI_FE_21_,                 \
    URBI_FE_20_, URBI_FE_19_, URBI_FE_18_, URBI_FE_17_, URBI_FE_16_, URBI_FE_15_,                 \
    URBI_FE_14_, URBI_FE_13_, URBI_FE_12_, URBI_FE_11_, URBI_FE_10_, URBI_FE_9_,                  \
    URBI_FE_8_, URBI_FE_7_, URBI_FE_6_, URBI_FE_5_, URBI_FE_4_, URBI_FE_3_, URBI_FE_2_,           \
    URBI_FE_1_, 0)                                                                                \
  (M, Data, __VA_ARGS__)

#define URBI_FE_PICK_(a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14, a15, a16,      \
  a17, a18, a19, a20, a21, a22, a23, a24, a25, a26, a27, a28, a29, a30, a31, a32, Name, ...) Name

#define URBI_FE_1_(M, D, a) M(D, a)
#define URBI_FE_2_(M, D, a, ...) M(D, a) URBI_FE_1_(M, D, __VA_ARGS__)
#define URBI_FE_3_(M, D, a, ...) M(D, a) URBI_FE_2_(M, D, __VA_ARGS__)
#define URBI_FE_4_(M, D, a, ...) M(D, a) URBI_FE_3_(M, D, __VA_ARGS__)
#define URBI_FE_5_(M, D, a, ...) M(D, a) URBI_FE_4_(M, D, __VA_ARGS__)
#define URBI_FE_6_(M, D, a, ...) M(D, a) URBI_FE_5_(M, D, __VA_ARGS__)
#define URBI_FE_7_(M, D, a, ...) M(D, a) URBI_FE_6_(M, D, __VA_ARGS__)
#define URBI_FE_8_(M, D, a, ...) M(D, a) URBI_FE_7_(M, D, __VA_ARGS__)
#define URBI_FE_9_(M, D, a, ...) M(D, a) URBI_FE_8_(M, D, __VA_ARGS__)
#define URBI_FE_10_(M, D, a, ...) M(D, a) URBI_FE_9_(M, D, __VA_ARGS__)
#define URBI_FE_11_(M, D, a, ...) M(D, a) URBI_FE_10_(M, D, __VA_ARGS__)
#define URBI_FE_12_(M, D, a, ...) M(D, a) URBI_FE_11_(M, D, __VA_ARGS__)
#define URBI_FE_13_(M, D, a, ...) M(D, a) URBI_FE_12_(M, D, __VA_ARGS__)
#define URBI_FE_14_(M, D, a, ...) M(D, a) URBI_FE_13_(M, D, __VA_ARGS__)
#define URBI_FE_15_(M, D, a, ...) M(D, a) URBI_FE_14_(M, D, __VA_ARGS__)
#define URBI_FE_16_(M, D, a, ...) M(D, a) URBI_FE_15_(M, D, __VA_ARGS__)
#define URBI_FE_17_(M, D, a, ...) M(D, a) URBI_FE_16_(M, D, __VA_ARGS__)
#define URBI_FE_18_(M, D, a, ...) M(D, a) URBI_FE_17_(M, D, __VA_ARGS__)
#define URBI_FE_19_(M, D, a, ...) M(D, a) URBI_FE_18_(M, D, __VA_ARGS__)
#define URBI_FE_20_(M, D, a, ...) M(D, a) URBI_FE_19_(M, D, __VA_ARGS__)
#define URBI_FE_21_(M, D, a, ...) M(D, a) URBI_FE_20_(M, D, __VA_ARGS__)
#define URBI_FE_22_(M, D, a, ...) M(D, a) URBI_FE_21_(M, D, __VA_ARGS__)
#define URBI_FE_23_(M, D, a, ...) M(D, a) URBI_FE_22_(M, D, __VA_ARGS__)
#define URBI_FE_24_(M, D, a, ...) M(D, a) URBI_FE_23_(M, D, __VA_ARGS__)
#define URBI_FE_25_(M, D, a, ...) M(D, a) URBI_FE_24_(M, D, __VA_ARGS__)
#define URBI_FE_26_(M, D, a, ...) M(D, a) URBI_FE_25_(M, D, __VA_ARGS__)
#define URBI_FE_27_(M, D, a, ...) M(D, a) URBI_FE_26_(M, D, __VA_ARGS__)
#define URBI_FE_28_(M, D, a, ...) M(D, a) URBI_FE_27_(M, D, __VA_ARGS__)
#define URBI_FE_29_(M, D, a, ...) M(D, a) URBI_FE_28_(M, D, __VA_ARGS__)
#define URBI_FE_30_(M, D, a, ...) M(D, a) URBI_FE_29_(M, D, __VA_ARGS__)
#define URBI_FE_31_(M, D, a, ...) M(D, a) URBI_FE_30_(M, D, __VA_ARGS__)
#define URBI_FE_32_(M, D, a, ...) M(D, a) URBI_FE_31_(M, D, __VA_ARGS__)

#endif
