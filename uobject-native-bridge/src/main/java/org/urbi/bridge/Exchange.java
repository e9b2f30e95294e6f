package org.urbi.bridge;

/**
 * The fields of one call across the boundary, see {@code urbi/detail/boundary.h}: {@code struct
 * urbi_exchange}, at some address.
 */
final class Exchange {
  /** Its size in bytes. */
  static final int SIZE = 64;

  /** What a call returns that has failed: the reply is the text of the error. */
  static final long FAILED = Long.MIN_VALUE;

  /**
   * The operation of a call that has failed because C++ code has let a failure of its host pass.
   */
  static final long PASSED = -1;

  private static final int OPERATION = 0;
  private static final int CONTEXT = 8;
  private static final int SUBJECT = 16;
  private static final int DATA = 24;
  private static final int LENGTH = 32;
  private static final int REPLY = 40;
  private static final int REPLY_CAPACITY = 48;
  private static final int REPLY_LENGTH = 56;

  private Exchange() {}

  static long operation(long exchange) {
    return RawMemory.getLong(exchange + OPERATION);
  }

  static void setOperation(long exchange, long operation) {
    RawMemory.putLong(exchange + OPERATION, operation);
  }

  static long context(long exchange) {
    return RawMemory.getLong(exchange + CONTEXT);
  }

  static void setContext(long exchange, long context) {
    RawMemory.putLong(exchange + CONTEXT, context);
  }

  static long subject(long exchange) {
    return RawMemory.getLong(exchange + SUBJECT);
  }

  static void setSubject(long exchange, long subject) {
    RawMemory.putLong(exchange + SUBJECT, subject);
  }

  static long data(long exchange) {
    return RawMemory.getLong(exchange + DATA);
  }

  static void setData(long exchange, long address, long length) {
    RawMemory.putLong(exchange + DATA, address);
    RawMemory.putLong(exchange + LENGTH, length);
  }

  static long length(long exchange) {
    return RawMemory.getLong(exchange + LENGTH);
  }

  static long reply(long exchange) {
    return RawMemory.getLong(exchange + REPLY);
  }

  static void setReply(long exchange, long address) {
    RawMemory.putLong(exchange + REPLY, address);
  }

  static long replyCapacity(long exchange) {
    return RawMemory.getLong(exchange + REPLY_CAPACITY);
  }

  static void setReplyCapacity(long exchange, long bytes) {
    RawMemory.putLong(exchange + REPLY_CAPACITY, bytes);
  }

  static long replyLength(long exchange) {
    return RawMemory.getLong(exchange + REPLY_LENGTH);
  }

  static void setReplyLength(long exchange, long bytes) {
    RawMemory.putLong(exchange + REPLY_LENGTH, bytes);
  }
}
