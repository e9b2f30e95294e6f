package org.urbi.server.studio;

import io.netty.channel.Channel;
import io.netty.handler.codec.http.websocketx.TextWebSocketFrame;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.urbi.kernel.Connection;
import org.urbi.kernel.observe.Sample;
import org.urbi.server.studio.access.LateAnswers;

/**
 * Reads the numbers that a browser plots, at equal intervals, as long as it reads what it is sent.
 * On the thread of the channel.
 */
final class Sampler {
  /** Between two samples, in milliseconds. */
  private static final int PERIOD = 50;

  private final Channel channel;
  private final Connection connection;
  private Request.Plot wanted = new Request.Plot(0, List.of());
  private boolean asking;

  Sampler(Channel channel, Connection connection) {
    this.channel = channel;
    this.connection = connection;
  }

  /** Other numbers are plotted from now on. */
  void plot(Request.Plot plot) {
    wanted = plot;
    sample();
  }

  /** Reads them, unless they are being read, nobody wants them, or the browser is behind. */
  void sample() {
    if (asking || wanted.ways().isEmpty() || !channel.isActive() || !channel.isWritable()) {
      return;
    }
    asking = true;
    long id = wanted.id();
    LateAnswers.take(channel, connection.sample(wanted.ways()), sample -> show(id, sample));
  }

  private void show(long id, Sample sample) {
    channel.writeAndFlush(new TextWebSocketFrame(VariableAnswer.sample(id, sample)));
    channel
        .eventLoop()
        .schedule(LateAnswers.guarding(channel, this::next), PERIOD, TimeUnit.MILLISECONDS);
  }

  private void next() {
    asking = false;
    sample();
  }
}
