package org.urbi.bridge;

/**
 * Caches the header of a binary in both forms: most binaries have the same header as the one
 * before.
 */
record HeaderCache(byte[] bytes, String text) {
  /** None yet. */
  static final HeaderCache NONE = new HeaderCache(new byte[0], "");

  /** Whether the same bytes are at an address. */
  boolean isAt(long address, int length) {
    if (bytes.length != length) {
      return false;
    }
    for (int i = 0; i < length; i++) {
      if (RawMemory.getByte(address + i) != bytes[i]) {
        return false;
      }
    }
    return true;
  }
}
