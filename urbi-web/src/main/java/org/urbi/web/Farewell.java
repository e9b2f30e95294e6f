package org.urbi.web;

import io.netty.buffer.ByteBuf;
import io.netty.channel.Channel;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import io.netty.channel.ChannelPipeline;
import io.netty.channel.socket.DuplexChannel;
import io.netty.handler.ssl.SslHandler;
import io.netty.util.ReferenceCountUtil;
import java.util.concurrent.TimeUnit;

/**
 * The end of a connection whose other end is told why. To close it while something comes in would
 * take back what has just been sent. So what comes is passed over until the other end has closed,
 * too; whoever goes on all the same is cut off after some bytes, and after some seconds.
 */
public final class Farewell extends ChannelInboundHandlerAdapter {
  /** What may have been on its way, in bytes, and not all that somebody would like to send. */
  static final int MOST = 1 << 22;

  static final int SECONDS = 2;

  private long passedOver;

  private Farewell() {}

  /**
   * Says the last thing, and ends the connection. What is said later is not sent.
   *
   * @param last what tells why
   */
  public static void say(Channel channel, Object last) {
    ChannelPipeline pipeline = channel.pipeline();
    if (pipeline.get(Farewell.class) != null) {
      ReferenceCountUtil.release(last);
      return;
    }
    Farewell rest = new Farewell();
    ChannelHandlerContext tls = pipeline.context(SslHandler.class);
    if (tls == null) {
      pipeline.addFirst(rest);
    } else {
      pipeline.addAfter(tls.name(), null, rest);
    }
    channel.writeAndFlush(last).addListener(written -> stopTalking(channel));
    ChannelHandlerContext here = pipeline.context(rest);
    channel.eventLoop().schedule((Runnable) here::close, SECONDS, TimeUnit.SECONDS);
  }

  /** Now the other end knows that nothing else will come. */
  private static void stopTalking(Channel channel) {
    if (channel instanceof DuplexChannel duplex) {
      duplex.shutdownOutput();
    }
  }

  @Override
  public void channelRead(ChannelHandlerContext context, Object message) {
    if (message instanceof ByteBuf bytes) {
      passedOver += bytes.readableBytes();
    }
    ReferenceCountUtil.release(message);
    if (passedOver > MOST) {
      context.close();
    }
  }
}
