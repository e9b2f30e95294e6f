package org.urbi.server.net;

import io.netty.buffer.ByteBuf;
import io.netty.buffer.Unpooled;
import io.netty.channel.ChannelFutureListener;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import java.nio.charset.StandardCharsets;
import java.util.function.Supplier;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.trust.Role;
import urbi.wire.Protocol;

/**
 * Examines the first bytes of a client: a process with UObjects asks for their protocol
 * (docs/protocol.md); the bytes of all other clients pass unchanged.
 */
final class ProtocolDetector extends ChannelInboundHandlerAdapter {
  private static final int MAX_REQUEST = 64;

  private final Supplier<FrameHandler> frames;
  private final String version;
  private final ByteBuf first = Unpooled.buffer(MAX_REQUEST);

  /**
   * @param frames makes the handler of the protocol
   * @param version of the server, for people
   */
  ProtocolDetector(Supplier<FrameHandler> frames, String version) {
    this.frames = frames;
    this.version = version;
  }

  @Override
  public void channelRead(ChannelHandlerContext context, Object message) {
    ByteBuf in = (ByteBuf) message;
    first.writeBytes(in);
    in.release();
    String text = first.toString(StandardCharsets.ISO_8859_1);
    int common = Math.min(text.length(), Protocol.REQUEST.length());
    int end = text.indexOf('\n');
    if (!text.startsWith(Protocol.REQUEST.substring(0, common))
        || end < 0 && text.length() > MAX_REQUEST) {
      removeSelf(context, 0);
    } else if (end >= 0) {
      agree(context, text.substring(Protocol.REQUEST.length(), end), end + 1);
    }
  }

  private void agree(ChannelHandlerContext context, String request, int length) {
    int agreed = Protocol.agree(request);
    if (agreed == 0) {
      refuse(context, Problem.PROTOCOL_VERSIONS.text(Protocol.MIN_VERSION, Protocol.MAX_VERSION));
      return;
    }
    if (TokenAuthenticator.role(context) != Role.OWNER) {
      refuse(context, Problem.UOBJECTS_NEED_OWNER.text());
      return;
    }
    String line = "[00000000:" + Protocol.CHANNEL + "] " + agreed + " " + version + "\n";
    context.writeAndFlush(Unpooled.copiedBuffer(line, StandardCharsets.ISO_8859_1));
    FrameHandler handler = frames.get();
    context.pipeline().remove(TelnetDecoder.class);
    context.pipeline().addAfter(context.name(), null, handler);
    removeSelf(context, length);
  }

  /** Removes itself, and passes on the bytes from an offset on. */
  private void removeSelf(ChannelHandlerContext context, int offset) {
    ByteBuf rest = first.retainedSlice(offset, first.writerIndex() - offset);
    context.pipeline().remove(this);
    context.fireChannelRead(rest);
  }

  private static void refuse(ChannelHandlerContext context, String reason) {
    context
        .writeAndFlush(ErrorLine.of(Protocol.CHANNEL, reason))
        .addListener(ChannelFutureListener.CLOSE);
  }

  @Override
  public void handlerRemoved(ChannelHandlerContext context) {
    first.release();
  }
}
