#!/bin/sh
# java-library.sh FOLDER: makes the library that programs written for the classic SDK load by
# System.loadLibrary("urbijava"). There is nothing in it, since the SDK is Java alone; but loading it
# has to work. Without a C compiler there is none: status 1.
case $(uname -s) in
  Darwin) file=liburbijava.dylib ;;
  *) file=liburbijava.so ;;
esac
for compiler in ${CC:-cc gcc clang}; do
  if command -v "$compiler" >/dev/null 2>&1; then
    echo 'const char urbijava[] = "the SDK is in liburbijava.jar";' |
      "$compiler" -shared -fPIC -x c - -o "$1/$file.$$" && mv -f "$1/$file.$$" "$1/$file"
    exit
  fi
done
echo "no C compiler (cc, gcc or clang): no $file" >&2
exit 1
