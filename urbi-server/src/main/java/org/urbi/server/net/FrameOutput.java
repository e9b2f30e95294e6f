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
 * The output to a process with UObjects. While nothing waits, the kernel thread itself writes to
 * the socket, which costs less than waking the network thread. The network thread sends the bytes
 * that the socket does not take.
 */
final class FrameOutput {
  private static final long LITTLE = 1L << 20;

  /** Beyond this backlog, values of variables are held back, so that only the newest is sent. */
  private static final long BACKLOG = 8L << 20;

  private final ChannelHandlerContext context;
  private final @Nullable SocketChannel socket;
  private final Runnable onBacklog;
  private final Runnable onDrained;
  private final ReentrantLock lock = new ReentrantLock();

  /** Frames from the kernel that the network thread has not yet taken. */
  private final Queue<ByteBuf> waiting = new ArrayDeque<>();

  private boolean late;
  private boolean scheduled;
  private int taken;
  private volatile long unsent;

  /**
   * @param onBacklog told when much waits
   * @param onDrained told, by the network thread, when much has waited and little is left
   */
  FrameOutput(ChannelHandlerContext context, Runnable onBacklog, Runnable onDrained) {
    this.context = context;
    ConsoleChannel bare = ConsoleChannel.bare(context);
    this.socket = bare == null ? null : bare.socketChannel();
    this.onBacklog = onBacklog;
    this.onDrained = onDrained;
  }

  /** The number of waiting bytes from the kernel. */
  long unsent() {
    return unsent;
  }

  /** Sends frames. Any thread may call this. */
  void send(byte[] frames) {
    lock.lock();
    try {
      int written = 0;
      if (socket != null && taken == 0 && waiting.isEmpty()) {
        written = writeNow(socket, frames);
      }
      if (written < frames.length) {
        unsent += frames.length - written;
        if (unsent > BACKLOG && !late) {
          late = true;
          onBacklog.run();
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
      // The network thread will get the same error, and handles it.
      return 0;
    }
  }

  /** Sends data of the network thread, on that thread. */
  void write(ChannelPromise promise, ByteBuf... parts) {
    takeKernelOutput();
    for (int i = 0; i < parts.length; i++) {
      boolean last = i == parts.length - 1;
      count(last ? context.write(parts[i], promise) : context.write(parts[i]), 0);
    }
  }

  /** Sends data of the network thread at once, on that thread. */
  void writeAndFlush(byte[] bytes) {
    write(context.newPromise(), Unpooled.wrappedBuffer(bytes));
    context.flush();
  }

  private void flush() {
    takeKernelOutput();
    context.flush();
  }

  /**
   * Takes the frames from the kernel. Called on the network thread, before anything else is
   * written.
   */
  private void takeKernelOutput() {
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
        onDrained.run();
      }
      lock.unlock();
    });
  }
}
