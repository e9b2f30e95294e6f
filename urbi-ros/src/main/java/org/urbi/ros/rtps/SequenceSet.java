package org.urbi.ros.rtps;

import java.nio.ByteBuffer;

/** At most 256 numbers from a base on: those of samples, or of a sample's fragments. */
final class SequenceSet {
  static final int LARGEST = 256;

  private final long base;
  private final int size;
  private final int[] words;

  private SequenceSet(long base, int size, int[] words) {
    this.base = base;
    this.size = size;
    this.words = words;
  }

  /** Nothing: all before {@code base} is there, and nothing is missing. */
  static SequenceSet empty(long base) {
    return new SequenceSet(base, 0, new int[0]);
  }

  /** Room for the numbers from {@code base} on. */
  static SequenceSet from(long base, int size) {
    int bounded = Math.min(size, LARGEST);
    return new SequenceSet(base, bounded, new int[(bounded + 31) / 32]);
  }

  static SequenceSet readSamples(ByteBuffer in) throws MalformedException {
    return readBits(in, Wire.sequence(in));
  }

  static SequenceSet readFragments(ByteBuffer in) throws MalformedException {
    return readBits(in, Wire.unsigned(in.getInt()));
  }

  private static SequenceSet readBits(ByteBuffer in, long base) throws MalformedException {
    int size = in.getInt();
    if (size < 0 || size > LARGEST)
      throw new MalformedException("set of " + Wire.unsigned(size) + " numbers");
    int[] words = new int[(size + 31) / 32];
    for (int i = 0; i < words.length; i++) words[i] = in.getInt();
    return new SequenceSet(base, size, words);
  }

  void writeSamples(ByteBuffer out) {
    Wire.putSequence(out, base);
    writeBits(out);
  }

  void writeFragments(ByteBuffer out) {
    out.putInt((int) base);
    writeBits(out);
  }

  private void writeBits(ByteBuffer out) {
    out.putInt(size);
    for (int word : words) out.putInt(word);
  }

  long base() {
    return base;
  }

  /** How many numbers from the base on it speaks of. */
  int size() {
    return size;
  }

  boolean contains(long number) {
    long index = number - base;
    return index >= 0 && index < size && (words[(int) index / 32] & bit((int) index)) != 0;
  }

  /** Adds a number that is within the size. */
  void add(long number) {
    int index = (int) (number - base);
    words[index / 32] |= bit(index);
  }

  boolean isEmpty() {
    for (int word : words) if (word != 0) return false;
    return true;
  }

  private static int bit(int index) {
    return 0x80000000 >>> (index % 32);
  }
}
