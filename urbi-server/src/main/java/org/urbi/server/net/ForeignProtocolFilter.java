package org.urbi.server.net;

import io.netty.buffer.ByteBuf;
import io.netty.buffer.Unpooled;
import io.netty.channel.ChannelFutureListener;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import io.netty.channel.socket.ChannelInputShutdownEvent;
import java.nio.charset.StandardCharsets;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.urbi.kernel.error.Problem;
import org.urbi.server.Trace;

/**
 * Examines the first bytes of a client, and disconnects it if it speaks HTTP, TLS or STUN. A web
 * page can make a browser send these protocols to any port of this machine, with text of its
 * choice, which would be executed as urbiscript. No byte of them reaches the lobby. All other input
 * passes unchanged, at the latest when the first line has ended.
 */
final class ForeignProtocolFilter extends ChannelInboundHandlerAdapter {
  /** A request line of HTTP (RFC 9112, section 3), as far as its version. */
  private static final Pattern HTTP =
      Pattern.compile(
          "(?:GET|HEAD|POST|PUT|DELETE|OPTIONS|PATCH|CONNECT|TRACE|PRI) [^ \r\n]+ HTTP/");

  /** The record of a TLS handshake, or of a STUN request, begins so (RFC 8446; RFC 8489). */
  private static final Pattern BINARY = Pattern.compile("\\x16\\x03|\\x00[\\x01\\x03]");

  /**
   * The longest undecided first line: no statement is so long without a second space or an end of
   * line.
   */
  private static final int MAX_DOUBT = 1 << 16;

  /** No method of HTTP is longer, with the space behind it. */
  private static final int LONGEST_METHOD = "OPTIONS ".length();

  private final Trace trace;
  private final ByteBuf first = Unpooled.buffer(256);
  private boolean refused;

  /**
   * Whether all that has come is the beginning of a request, up to somewhere in its target: until
   * that has ended, nothing else decides.
   */
  private boolean inTarget;

  ForeignProtocolFilter(Trace trace) {
    this.trace = trace;
  }

  @Override
  public void channelRead(ChannelHandlerContext context, Object message) {
    ByteBuf in = (ByteBuf) message;
    if (refused) {
      in.release();
      return;
    }
    boolean decidesNothing =
        inTarget
            && in.forEachByte(each -> each != ' ' && each != '\r' && each != '\n') < 0
            && first.readableBytes() + in.readableBytes() < MAX_DOUBT;
    first.writeBytes(in);
    in.release();
    if (!decidesNothing) {
      examine(context);
    }
  }

  private void examine(ChannelHandlerContext context) {
    String text =
        first.toString(0, Math.min(first.readableBytes(), MAX_DOUBT), StandardCharsets.ISO_8859_1);
    Matcher http = HTTP.matcher(text);
    Matcher binary = BINARY.matcher(text);
    if (http.lookingAt()) {
      refuse(context, "HTTP");
    } else if (binary.lookingAt()) {
      refuse(context, "TLS or STUN");
    } else if (!http.hitEnd() && !binary.hitEnd()) {
      passOn(context);
    } else if (text.length() == MAX_DOUBT) {
      refuse(context, "HTTP");
    } else {
      int method = text.indexOf(' ');
      inTarget = text.length() > LONGEST_METHOD && text.indexOf(' ', method + 1) < 0;
    }
  }

  private void passOn(ChannelHandlerContext context) {
    ByteBuf rest = first.retainedSlice();
    context.pipeline().remove(this);
    context.fireChannelRead(rest);
  }

  /** At the end of the input, the undecided bytes are passed on. */
  @Override
  public void userEventTriggered(ChannelHandlerContext context, Object event) {
    if (event == ChannelInputShutdownEvent.INSTANCE && !refused) {
      passOn(context);
    }
    context.fireUserEventTriggered(event);
  }

  private void refuse(ChannelHandlerContext context, String protocol) {
    trace.turnedAway(
        "client refused, it speaks " + protocol + ": " + context.channel().remoteAddress());
    context.channel().config().setAutoRead(false);
    context
        .writeAndFlush(ErrorLine.closing(Problem.FOREIGN_PROTOCOL.text(protocol)))
        .addListener(ChannelFutureListener.CLOSE);
    first.clear();
    refused = true;
  }

  @Override
  public void handlerRemoved(ChannelHandlerContext context) {
    first.release();
  }
}
