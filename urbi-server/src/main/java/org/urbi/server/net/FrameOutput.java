package org.urbi.server.net;

import io.netty.buffer.ByteBuf;
import io.netty.buffer.Unpooled;
import io.netty.channel.ChannelFuture;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelPromise;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.SocketChannel;
import java.util.ArrayDeque;
import java.util.Queue;
import java.util.concurrent.locks.ReentrantLock;
import org.jspecify.annotations.Nullable;

/**
 * What is sent to a process with UObjects. While nothing waits, the kernel's thread itself writes
 * to the socket, which costs less than to wake the network's; what the socket does not take is left
 * to that.
 */
final class FrameOutput {
  private static final long LITTLE = 1L << 20;

  /** When more waits, values of variables wait until they can be the latest. */
  private static final long MUCH = 8L << 20;

  private final ChannelHandlerContext context;
  private final @Nullable SocketChannel socket;
  private final Runnable behind;
  private final Runnable drained;
  private final ReentrantLock lock = new ReentrantLock();

  /** What the kernel has sent and the network thread has not taken yet. */
  private final Queue<ByteBuf> waiting = new ArrayDeque<>();

  private boolean late;
  private boolean scheduled;
  private int taken;
  private volatile long unsent;

  /**
   * @param behind told when much waits
   * @param drained told, by the network thread, when much has waited and little is left
   */
  FrameOutput(ChannelHandlerContext context, Runnable behind, Runnable drained) {
    this.context = context;
    this.socket = context.channel() instanceof ConsoleChannel own ? own.bare() : null;
    this.behind = behind;
    this.drained = drained;
  }

  /** How many bytes of the kernel wait. */
  long unsent() {
    return unsent;
  }

  /** Sends frames; by any thread. */
  void send(byte[] frames) {
    lock.lock();
    try {
      int written = 0;
      if (socket != null && taken == 0 && waiting.isEmpty()) {
        written = writeNow(socket, frames);
      }
      if (written < frames.length) {
        unsent += frames.length - written;
        if (unsent > MUCH && !late) {
          late = true;
          behind.run();
        }
        waiting.add(Unpooled.wrappedBuffer(frames, written, frames.length - written));
        if (!scheduled) {
          scheduled = true;
          NetworkThread.execute(context.executor(), this::flush);
        }
      }
    } finally {
      lock.unlock();
    }
  }

  private static int writeNow(SocketChannel socket, byte[] frames) {
    try {
      return Math.max(0, socket.write(ByteBuffer.wrap(frames)));
    } catch (IOException e) {
      // The network thread sees the same, and knows what to do.
      return 0;
    }
  }

  /** Sends something of the network thread's own, by that. */
  void write(ChannelPromise promise, ByteBuf... parts) {
    handOver();
    for (int i = 0; i < parts.length; i++) {
      boolean last = i == parts.length - 1;
      count(last ? context.write(parts[i], promise) : context.write(parts[i]), 0);
    }
  }

  /** Sends something of the network thread's own at once, by that. */
  void writeAndFlush(byte[] bytes) {
    write(context.newPromise(), Unpooled.wrappedBuffer(bytes));
    context.flush();
  }

  private void flush() {
    handOver();
    context.flush();
  }

  /** Passes on what the kernel has sent; on the network thread, before anything else. */
  private void handOver() {
    lock.lock();
    try {
      scheduled = false;
      taken++;
      for (ByteBuf frames = waiting.poll(); frames != null; frames = waiting.poll()) {
        int size = frames.readableBytes();
        count(context.write(frames), size);
      }
    } finally {
      taken--;
      lock.unlock();
    }
  }

  private void count(ChannelFuture written, int size) {
    lock.lock();
    taken++;
    lock.unlock();
    written.addListener(done -> {
      lock.lock();
      unsent -= size;
      taken--;
      if (late && unsent <= LITTLE) {
        late = false;
        drained.run();
      }
      lock.unlock();
    });
  }
}
