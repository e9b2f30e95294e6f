package org.urbi.server.net;

import io.netty.buffer.ByteBuf;
import io.netty.channel.Channel;
import io.netty.channel.ChannelConfig;
import io.netty.channel.ChannelFuture;
import io.netty.channel.ChannelPromise;
import io.netty.channel.DefaultChannelConfig;
import io.netty.channel.FileRegion;
import io.netty.channel.nio.AbstractNioByteChannel;
import io.netty.channel.socket.ChannelInputShutdownEvent;
import io.netty.channel.socket.DuplexChannel;
import java.io.IOException;
import java.net.SocketAddress;
import java.nio.channels.SocketChannel;

/**
 * The channel of a client of a Unix domain socket. Unlike Netty's own it lets a client end its
 * stream and still be answered.
 */
final class UnixChannel extends AbstractNioByteChannel implements DuplexChannel {
  private static final SocketAddress CLIENT =
      new SocketAddress() {
        private static final long serialVersionUID = 1;

        @Override
        public String toString() {
          return "a client of the socket";
        }
      };

  private final ChannelConfig config = new DefaultChannelConfig(this);
  private volatile boolean inputEnded;
  private volatile boolean outputEnded;

  UnixChannel(Channel listener, SocketChannel socket) {
    super(listener, socket);
  }

  @Override
  protected SocketChannel javaChannel() {
    return (SocketChannel) super.javaChannel();
  }

  @Override
  protected int doReadBytes(ByteBuf space) throws IOException {
    var handle = unsafe().recvBufAllocHandle();
    handle.attemptedBytesRead(space.writableBytes());
    int size = space.writeBytes(javaChannel(), handle.attemptedBytesRead());
    if (size >= 0) {
      return size;
    }
    // Netty would close the channel.
    inputEnded = true;
    clearReadPending();
    eventLoop()
        .execute(() -> pipeline().fireUserEventTriggered(ChannelInputShutdownEvent.INSTANCE));
    return 0;
  }

  @Override
  protected void doBeginRead() throws Exception {
    if (!inputEnded) {
      super.doBeginRead();
    }
  }

  @Override
  protected int doWriteBytes(ByteBuf bytes) throws IOException {
    return bytes.readBytes(javaChannel(), bytes.readableBytes());
  }

  @Override
  protected long doWriteFileRegion(FileRegion region) throws IOException {
    return region.transferTo(javaChannel(), region.transferred());
  }

  @Override
  public ChannelConfig config() {
    return config;
  }

  @Override
  public boolean isActive() {
    return isOpen() && javaChannel().isConnected();
  }

  @Override
  protected SocketAddress localAddress0() {
    return CLIENT;
  }

  @Override
  protected SocketAddress remoteAddress0() {
    return CLIENT;
  }

  @Override
  protected void doClose() throws IOException {
    javaChannel().close();
  }

  // ------------------------------------------------------------------ one direction

  @Override
  public boolean isInputShutdown() {
    return inputEnded;
  }

  @Override
  protected boolean isInputShutdown0() {
    return inputEnded;
  }

  @Override
  public boolean isOutputShutdown() {
    return outputEnded;
  }

  @Override
  public boolean isShutdown() {
    return inputEnded && outputEnded;
  }

  @Override
  public ChannelFuture shutdownOutput() {
    return shutdownOutput(newPromise());
  }

  @Override
  public ChannelFuture shutdownOutput(ChannelPromise promise) {
    return carryOut(promise, this::endOutput);
  }

  @Override
  protected void doShutdownOutput() throws IOException {
    endOutput();
  }

  private void endOutput() throws IOException {
    javaChannel().shutdownOutput();
    outputEnded = true;
  }

  @Override
  public ChannelFuture shutdownInput() {
    return shutdownInput(newPromise());
  }

  @Override
  public ChannelFuture shutdownInput(ChannelPromise promise) {
    return carryOut(promise, this::endInput);
  }

  private void endInput() throws IOException {
    javaChannel().shutdownInput();
    inputEnded = true;
  }

  @Override
  public ChannelFuture shutdown() {
    return shutdown(newPromise());
  }

  @Override
  public ChannelFuture shutdown(ChannelPromise promise) {
    return carryOut(
        promise,
        () -> {
          endInput();
          endOutput();
        });
  }

  private interface Work {
    void run() throws IOException;
  }

  private ChannelFuture carryOut(ChannelPromise promise, Work work) {
    eventLoop()
        .execute(() -> {
          try {
            work.run();
            promise.setSuccess();
          } catch (IOException e) {
            promise.setFailure(e);
          }
        });
    return promise;
  }

  // ------------------------------------------------------------------ it is connected already

  @Override
  protected boolean doConnect(SocketAddress remote, SocketAddress local) {
    throw new UnsupportedOperationException();
  }

  @Override
  protected void doFinishConnect() {
    throw new UnsupportedOperationException();
  }

  @Override
  protected void doBind(SocketAddress address) {
    throw new UnsupportedOperationException();
  }

  @Override
  protected void doDisconnect() throws IOException {
    doClose();
  }
}
