package org.urbi.server.studio;

import io.netty.channel.Channel;
import io.netty.handler.codec.http.websocketx.TextWebSocketFrame;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.Connection;
import org.urbi.server.studio.access.LateAnswers;

/**
 * The images and sounds that a browser is shown, one after the other: they are large, and one that
 * does not read them must not make the server keep many. On the thread of the channel.
 */
final class MediaDesk {
  private final Channel channel;
  private final Connection connection;
  private Request.@Nullable Show wanted;
  private boolean fetching;

  MediaDesk(Channel channel, Connection connection) {
    this.channel = channel;
    this.connection = connection;
  }

  /** Answers what is wanted, as soon as the browser has read what it was sent before. */
  void obey(Request.Show wish) {
    if (wanted == null) {
      wanted = wish;
      fetch();
    } else {
      send(Answer.done(wish.id(), "one image or sound after the other: wait for the answer"));
    }
  }

  /** Fetches what is wanted, unless nothing is, or the browser is behind. */
  void fetch() {
    Request.Show wish = wanted;
    if (wish == null || fetching || !channel.isWritable()) {
      return;
    }
    fetching = true;
    LateAnswers.take(
        channel,
        connection.media(wish.way()),
        media -> {
          wanted = null;
          fetching = false;
          send(VariableAnswer.shown(wish.id(), media));
        });
  }

  private void send(String text) {
    channel.writeAndFlush(new TextWebSocketFrame(text));
  }
}
