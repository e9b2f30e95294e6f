package org.urbi.web;

import io.netty.buffer.ByteBuf;
import io.netty.channel.ChannelFutureListener;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import io.netty.handler.codec.http.DefaultHttpContent;
import io.netty.handler.codec.http.DefaultHttpResponse;
import io.netty.handler.codec.http.HttpHeaderNames;
import io.netty.handler.codec.http.HttpHeaderValues;
import io.netty.handler.codec.http.HttpResponse;
import io.netty.handler.codec.http.HttpResponseStatus;
import io.netty.handler.codec.http.HttpVersion;
import io.netty.handler.codec.http.LastHttpContent;
import io.netty.handler.timeout.WriteTimeoutHandler;
import io.netty.util.ReferenceCountUtil;
import java.io.EOFException;
import java.io.IOException;
import java.net.URLEncoder;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/**
 * Sends a file to a browser, which keeps it, and then ends the connection. A piece of it is read
 * when the one before has left: however long the file is and however slow the browser, no more than
 * a piece is in memory, and others are served in between.
 */
final class Delivery extends ChannelInboundHandlerAdapter {
  static final int PIECE = 1 << 16;

  /** For how long a browser may not take a piece. */
  private static final int STALLED_SECONDS = 60;

  private final String name;
  private final FileChannel file;
  private final long size;
  private long position;

  /**
   * @throws IOException if the file cannot be read
   */
  Delivery(Path path) throws IOException {
    name = String.valueOf(path.getFileName());
    file = FileChannel.open(path, StandardOpenOption.READ);
    size = file.size();
  }

  @Override
  public void handlerAdded(ChannelHandlerContext context) {
    context.pipeline().addBefore(context.name(), null, new WriteTimeoutHandler(STALLED_SECONDS));
    context.write(head());
    goOn(context);
  }

  private HttpResponse head() {
    String written = URLEncoder.encode(name, StandardCharsets.UTF_8).replace("+", "%20");
    HttpResponse head = new DefaultHttpResponse(HttpVersion.HTTP_1_1, HttpResponseStatus.OK);
    head.headers()
        .set(HttpHeaderNames.CONTENT_TYPE, HttpHeaderValues.APPLICATION_OCTET_STREAM)
        .set(HttpHeaderNames.CONTENT_LENGTH, size)
        .set(HttpHeaderNames.CONTENT_DISPOSITION, "attachment; filename*=UTF-8''" + written)
        .set(HttpHeaderNames.CACHE_CONTROL, HttpHeaderValues.NO_STORE)
        .set(HttpHeaderNames.CONNECTION, HttpHeaderValues.CLOSE)
        .set("x-content-type-options", "nosniff")
        .set("referrer-policy", "no-referrer");
    return head;
  }

  private void goOn(ChannelHandlerContext context) {
    if (position == size) {
      context
          .writeAndFlush(LastHttpContent.EMPTY_LAST_CONTENT)
          .addListener(ChannelFutureListener.CLOSE);
      return;
    }
    ByteBuf piece = context.alloc().buffer((int) Math.min(PIECE, size - position));
    try {
      int read = piece.writeBytes(file, position, piece.capacity());
      if (read <= 0) {
        throw new EOFException("the file has become shorter");
      }
      position += read;
    } catch (IOException e) {
      piece.release();
      // Who is sent less than he was told knows that something is missing.
      context.close();
      return;
    }
    context
        .writeAndFlush(new DefaultHttpContent(piece))
        .addListener(sent -> {
          if (sent.isSuccess()) {
            goOn(context);
          } else {
            context.close();
          }
        });
  }

  /** Whatever is asked for beside is not answered: the connection ends. */
  @Override
  public void channelRead(ChannelHandlerContext context, Object message) {
    ReferenceCountUtil.release(message);
  }

  @Override
  public void exceptionCaught(ChannelHandlerContext context, Throwable cause) {
    StreamFailure.close(context, cause, "a download");
  }

  @Override
  public void handlerRemoved(ChannelHandlerContext context) throws IOException {
    file.close();
  }
}
