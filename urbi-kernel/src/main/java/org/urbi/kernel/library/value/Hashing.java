package org.urbi.kernel.library.value;

import java.util.List;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiHash;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;

/** Hashes of values (manual, "Hash"), directly where they are plain numbers or strings. */
public final class Hashing {
  /** So many characters are looked at between two checks whether to continue. */
  private static final int PIECE = 1 << 14;

  private Hashing() {}

  /** A new {@code Hash}. */
  public static UrbiHash hash(Frame caller, long code) {
    UrbiObject prototype = caller.interpreter().world().prototype("Hash");
    return new UrbiHash(prototype.cloneShape(), code);
  }

  public static long code(double number) {
    // Both zeros are the same number.
    return UrbiHash.mix(1, Double.doubleToLongBits(number + 0.0));
  }

  /** The code of a text, however long. */
  public static long code(Frame caller, String text) {
    long code = 2;
    int end = 0;
    while (end < text.length()) {
      int begin = end;
      end += Math.min(PIECE, text.length() - begin);
      for (int i = begin; i < end; i++) {
        code = UrbiHash.mix(code, text.charAt(i));
      }
      caller.job().worked(end - begin);
    }
    return code;
  }

  /** The code of elements in their order. */
  public static long code(Frame caller, List<UrbiObject> elements) {
    long code = 3;
    for (UrbiObject element : List.copyOf(elements)) {
      code = UrbiHash.mix(code, code(caller, element));
    }
    return code;
  }

  /** The code of any value, by its {@code hash}. */
  public static long code(Frame caller, UrbiObject value) {
    if (value instanceof UrbiFloat number && Comparison.isPlain(caller, value, "hash")) {
      caller.job().worked(1);
      return code(number.value());
    }
    if (value instanceof UrbiString text && Comparison.isPlain(caller, value, "hash")) {
      return code(caller, text.value());
    }
    UrbiObject hash = caller.interpreter().send(caller, value, "hash");
    if (hash instanceof UrbiHash known) {
      return known.code();
    }
    if (hash instanceof UrbiFloat number) {
      return code(number.value());
    }
    throw caller
        .interpreter()
        .errors()
        .argumentType("hash", 0, hash, caller.interpreter().world().prototype("Hash"));
  }
}
