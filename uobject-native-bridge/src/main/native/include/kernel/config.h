/// What there is on this machine.
#ifndef KERNEL_CONFIG_H
#define KERNEL_CONFIG_H

#if defined __has_include
#if __has_include(<sys/soundcard.h>)
#define HAVE_SYS_SOUNDCARD_H 1
#endif
#endif

#endif
