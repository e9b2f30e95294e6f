package org.urbi.kernel.object;

/** The hash of a value (manual, "Hash"): equal values have equal hashes. */
public final class UrbiHash extends UrbiObject {
  /** Codes have as many bits as a Float shows exactly. */
  private static final long MASK = (1L << 52) - 1;

  private long code;

  public UrbiHash(Shape shape, long code) {
    super(shape);
    this.code = code & MASK;
  }

  /** The hash as a number, from 0 to 2<sup>52</sup>. */
  public long code() {
    return code;
  }

  /** Combines it with the hash of a further value. */
  public void combine(long other) {
    code = mix(code, other);
  }

  /** The code of something composed of two parts, in this order. */
  public static long mix(long first, long second) {
    long mixed = (first * 31 + second) * 0x9E3779B97F4A7C15L;
    return (mixed ^ mixed >>> 29) & MASK;
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiHash(cloneShape(), code);
  }
}
