package org.urbi.kernel.library.file;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class SimplifiedPathTest {
  /** Of all short paths there are: that their parts are what is left of them. */
  @Test
  void pathsAreTheirNames() {
    String letters = "/.a";
    for (int length = 0; length <= 7; length++) {
      for (int code = 0; code < Math.pow(letters.length(), length); code++) {
        StringBuilder path = new StringBuilder();
        int rest = code;
        for (int i = 0; i < length; i++) {
          path.append(letters.charAt(rest % letters.length()));
          rest /= letters.length();
        }
        String text = path.toString();
        assertEquals(plain(text), UrbiPath.simplified(text), text);
      }
    }
  }

  private static String plain(String path) {
    StringBuilder names = new StringBuilder();
    for (String name : path.split("/")) {
      if (!name.isEmpty() && !name.equals(".")) {
        names.append(names.isEmpty() ? "" : "/").append(name);
      }
    }
    if (path.startsWith("/")) {
      return "/" + names;
    }
    return names.isEmpty() ? "." : names.toString();
  }
}
