package org.urbi.kernel.object;

/** What stands for a value in the search for it (manual, "Hash"): equal values have equal ones. */
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

  /** Makes it the hash of all it was the hash of, followed by something else. */
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
