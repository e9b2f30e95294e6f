package org.urbi.server.studio.foxglove;

import io.netty.handler.codec.http.websocketx.WebSocketFrame;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.observe.VariableKind;
import org.urbi.kernel.observe.VariableListener;
import org.urbi.server.studio.access.PageClient;
import org.urbi.server.studio.messages.Form;
import org.urbi.server.studio.messages.Topic;

/**
 * Hands what the kernel tells to the thread of a program: values by its outbox, and which channels
 * there are in groups, since many come at once.
 */
final class Feed implements VariableListener {
  /** The channel of the log. */
  static final int LOG_CHANNEL = 0;

  private final PageClient client;
  private final Outbox outbox;
  private final Subscriptions subscriptions;
  private final Function<Topic, Form> forms;
  private final Consumer<WebSocketFrame> send;
  private final Runnable values;

  /** Used on the thread of the program. */
  private final Map<Integer, Topic> appeared = new LinkedHashMap<>();

  private final List<Integer> gone = new ArrayList<>();
  private boolean telling;

  /**
   * @param forms how the messages of a topic are written
   * @param send sends a frame, on the thread of the program
   * @param values called there when there are values in the outbox
   */
  Feed(
      PageClient client,
      Outbox outbox,
      Subscriptions subscriptions,
      Function<Topic, Form> forms,
      Consumer<WebSocketFrame> send,
      Runnable values) {
    this.client = client;
    this.outbox = outbox;
    this.subscriptions = subscriptions;
    this.forms = forms;
    this.send = send;
    this.values = values;
  }

  @Override
  public void appeared(int variable, String path, VariableKind kind) {
    client.execute(() -> {
      Topic topic = new Topic(path, kind);
      appeared.put(variable, topic);
      tellLater();
    });
  }

  @Override
  public void gone(int variable) {
    client.execute(() -> {
      subscriptions.gone(variable);
      if (appeared.remove(variable) == null) {
        gone.add(variable);
        tellLater();
      }
    });
  }

  private void tellLater() {
    if (!telling) {
      telling = true;
      client.execute(this::tell);
    }
  }

  private void tell() {
    telling = false;
    if (!gone.isEmpty()) {
      send.accept(Answer.unadvertise(gone));
      gone.clear();
    }
    if (!appeared.isEmpty()) {
      appeared.forEach(subscriptions::appeared);
      send.accept(Answer.advertise(appeared, forms));
      appeared.clear();
    }
  }

  @Override
  public void value(int variable, long time, @Nullable Object value) {
    if (outbox.put(new Outbox.Value(variable, time, value))) {
      client.execute(values);
    }
  }

  @Override
  public void logged(long time, String line) {
    value(LOG_CHANNEL, time, line);
  }

  @Override
  public void refused(String reason) {
    client.execute(() -> send.accept(Answer.status(Answer.Level.WARNING, reason)));
  }
}
