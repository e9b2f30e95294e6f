package org.urbi.bridge;

import com.sun.jna.Native;
import java.util.ArrayDeque;
import java.util.concurrent.atomic.AtomicReference;

/** An exchange with its buffers, for calls into C++ code. Frames are reused. */
final class CallFrame {
  private static final int BUFFER = 1024;
  private static final int MAX_SPARE = 32;

  /** The one that was given back last, which is nearly always enough, and the others. */
  private static final AtomicReference<CallFrame> LAST = new AtomicReference<>();

  private static final ArrayDeque<CallFrame> SPARE = new ArrayDeque<>();

  /** Where the exchange is. */
  final long exchange;

  /** Writes the arguments. */
  final ValueWriter arguments;

  private final long answer;

  private CallFrame() {
    exchange = Native.malloc(Exchange.SIZE + 2L * BUFFER);
    if (exchange == 0) {
      throw new OutOfMemoryError("no memory for a call into C++ code");
    }
    arguments = new ValueWriter(exchange + Exchange.SIZE, BUFFER);
    answer = exchange + Exchange.SIZE + BUFFER;
    Exchange.setReplyCapacity(exchange, BUFFER);
  }

  /** A frame, to be given back by {@link #release}. */
  static CallFrame take() {
    CallFrame last = LAST.getAndSet(null);
    if (last != null) {
      return last;
    }
    synchronized (SPARE) {
      CallFrame spare = SPARE.poll();
      if (spare != null) {
        return spare;
      }
    }
    return new CallFrame();
  }

  /** What to call, and about what. */
  void prepare(long operation, long context, long subject) {
    Exchange.setOperation(exchange, operation);
    Exchange.setContext(exchange, context);
    Exchange.setSubject(exchange, subject);
    Exchange.setData(exchange, arguments.address(), arguments.length());
    Exchange.setReply(exchange, answer);
    Exchange.setReplyLength(exchange, 0);
  }

  /** Reads the reply. */
  ValueReader reply() {
    return new ValueReader(Exchange.reply(exchange), Exchange.replyLength(exchange));
  }

  /**
   * Why a call has failed: what C++ code has thrown, or the failure of a request that it let pass.
   */
  RuntimeException failure() {
    RuntimeException passed =
        Exchange.operation(exchange) == Exchange.PASSED ? RequestHandler.passed() : null;
    return passed == null ? new NativeException(error()) : passed;
  }

  /** The reply of a call that has failed. */
  String error() {
    return RawMemory.getText(
        Exchange.reply(exchange), Math.toIntExact(Exchange.replyLength(exchange)));
  }

  /** The call is over. */
  void release(ModuleFunctions entries) {
    long reply = Exchange.reply(exchange);
    if (reply != answer) {
      entries.free(reply);
    }
    arguments.release();
    arguments.restart();
    if (LAST.compareAndSet(null, this)) {
      return;
    }
    synchronized (SPARE) {
      if (SPARE.size() < MAX_SPARE) {
        SPARE.push(this);
        return;
      }
    }
    Native.free(exchange);
  }
}
