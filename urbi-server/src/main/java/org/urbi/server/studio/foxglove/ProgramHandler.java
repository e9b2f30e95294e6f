package org.urbi.server.studio.foxglove;

import static java.util.Objects.requireNonNull;

import io.netty.buffer.ByteBuf;
import io.netty.buffer.ByteBufUtil;
import io.netty.channel.Channel;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelOutboundBuffer;
import io.netty.handler.codec.http.QueryStringDecoder;
import io.netty.handler.codec.http.websocketx.BinaryWebSocketFrame;
import io.netty.handler.codec.http.websocketx.TextWebSocketFrame;
import io.netty.handler.codec.http.websocketx.WebSocketFrame;
import io.netty.handler.codec.http.websocketx.WebSocketFrameAggregator;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.Client;
import org.urbi.kernel.Connection;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.trust.Role;
import org.urbi.server.studio.access.Admission;
import org.urbi.server.studio.access.LateAnswers;
import org.urbi.server.studio.access.PageClient;
import org.urbi.server.studio.access.StreamHandler;
import org.urbi.server.studio.messages.BadMessage;
import org.urbi.server.studio.messages.Form;
import org.urbi.server.studio.messages.Json;
import org.urbi.server.studio.messages.RosType;
import org.urbi.server.studio.messages.Topic;

/**
 * A program that speaks Foxglove's WebSocket protocol. When it has been let in, it has a connection
 * to the kernel, with a lobby whose role is what it may do. Values that it does not read are left
 * out; the kernel never waits for it.
 */
public final class ProgramHandler extends StreamHandler {
  /** The names of the protocol, the best one first. */
  public static final List<String> SUBPROTOCOLS =
      List.of("foxglove.sdk.v1", "foxglove.websocket.v1");

  /** How many bytes a message of a program may have. */
  public static final int LONGEST = 1 << 18;

  /** How many requests may come at once, and in each second. */
  private static final int MOST_REQUESTS = 400;

  /** What a program has not read, in bytes, when it is let go. */
  private static final long MOST_UNREAD = 16 << 20;

  /** How many values are sent before others have their turn. */
  private static final int AT_ONCE = 200;

  private static final int MOST_PUBLICATIONS = 1000;
  private static final String JSON = "json";
  private static final String ROS = "ros2";
  private static final byte PUBLISHED = 1;
  private static final byte CALLED = 2;

  private final Function<Client, Connection> lobbies;
  private final List<String> watched;
  private final Outbox outbox = new Outbox();
  private final Map<Long, Request.Publication> publications = new HashMap<>();
  private @Nullable Program program;

  /** What there is of it once it has been let in. */
  private record Program(Connection connection, Subscriptions subscriptions, boolean ros) {}

  /**
   * @param lobbies makes the lobby of a program that has been let in
   * @param watched the paths of slots that are told besides the variables
   */
  public ProgramHandler(
      Admission admission, Function<Client, Connection> lobbies, List<String> watched) {
    super(admission, MOST_REQUESTS);
    this.lobbies = lobbies;
    this.watched = watched;
  }

  @Override
  public void handlerAdded(ChannelHandlerContext context) {
    context.pipeline().addBefore(context.name(), null, new WebSocketFrameAggregator(LONGEST));
  }

  // ------------------------------------------------------------------ who it is

  @Override
  protected void admitted(Channel channel, Role role, String uri) {
    PageClient client =
        new PageClient(
            channel,
            role,
            bytes ->
                channel.writeAndFlush(Answer.status(Answer.Level.INFO, Utf8Text.toJava(bytes))));
    Connection connection = lobbies.apply(client);
    Runnable values = () -> tell(channel);
    JobsFeed jobs =
        new JobsFeed(
            channel,
            connection,
            (time, all) -> {
              if (outbox.put(new Outbox.Value(JobsFeed.CHANNEL, time, all))) {
                client.execute(values);
              }
            });
    Subscriptions subscriptions =
        new Subscriptions((variable, on) -> {
          if (variable == JobsFeed.CHANNEL) {
            jobs.follow(on);
          } else {
            connection.follow(variable, on);
          }
        });
    String messages = messages(uri);
    boolean ros = messages.equals(ROS);
    Function<Topic, Form> forms = ros ? Form::rosOrJson : Form::json;
    program = new Program(connection, subscriptions, ros);
    send(channel, Answer.serverInfo(role));
    if (!ros && !messages.equals(JSON)) {
      String problem = "messages: " + JSON + " or " + ROS + " expected, not " + messages;
      send(channel, Answer.status(Answer.Level.WARNING, problem + "; they are " + JSON));
    }
    Map<Integer, Topic> ofKernel =
        Map.of(Feed.LOG_CHANNEL, Topic.LOG, JobsFeed.CHANNEL, Topic.JOBS);
    ofKernel.forEach(subscriptions::appeared);
    send(channel, Answer.advertise(ofKernel, forms));
    if (role != Role.OBSERVER) {
      send(channel, Answer.advertiseCalls());
    }
    Feed feed =
        new Feed(client, outbox, subscriptions, forms, frame -> send(channel, frame), values);
    connection.feed(feed, false, watched);
  }

  /** How the address wants messages to be written: not all programs can read those of ROS 2. */
  private static String messages(String uri) {
    return new QueryStringDecoder(uri)
        .parameters()
        .getOrDefault("messages", List.of(JSON))
        .getFirst();
  }

  @Override
  protected WebSocketFrame refusal(String reason, int again) {
    return Answer.status(Answer.Level.ERROR, reason);
  }

  // ------------------------------------------------------------------ what it is told

  private static void send(Channel channel, WebSocketFrame frame) {
    channel.writeAndFlush(frame);
    ChannelOutboundBuffer unread = channel.unsafe().outboundBuffer();
    if (unread != null && unread.totalPendingWriteBytes() > MOST_UNREAD) {
      // Whoever never reads, and is told of ever more channels.
      channel.close();
    }
  }

  /** Sends what has happened, as long as it is read. */
  private void tell(Channel channel) {
    long time = 0;
    int left = AT_ONCE;
    Outbox.Value next = channel.isWritable() ? outbox.take() : null;
    while (next != null) {
      time = next.time();
      tell(channel, next);
      next = channel.isWritable() && --left > 0 ? outbox.take() : null;
    }
    if (left == 0) {
      // Others have their turn.
      channel.eventLoop().execute(LateAnswers.guarding(channel, () -> tell(channel)));
    }
    if (time != 0) {
      channel.write(Answer.time(time));
    }
    long lost = channel.isWritable() ? outbox.lost() : 0;
    if (lost > 0) {
      channel.write(
          Answer.status(
              Answer.Level.WARNING, lost + " values were left out: they come faster than read"));
    }
    channel.flush();
  }

  private void tell(Channel channel, Outbox.Value value) {
    Subscriptions subscriptions = program().subscriptions();
    Topic topic = subscriptions.topic(value.channel());
    if (topic == null) {
      return;
    }
    List<Long> wanted = subscriptions.of(value.channel());
    if (!wanted.isEmpty()) {
      byte[] message = message(topic, value);
      if (message != null) {
        for (long subscription : wanted) {
          channel.write(Answer.message(subscription, value.time(), message));
        }
      }
    }
    if (subscriptions.isWatched(topic)) {
      List<@Nullable Object> values = new ArrayList<>();
      values.add(value.value());
      channel.write(Answer.parameterValues(List.of(topic.path()), values, null));
    }
  }

  /**
   * A message as it was announced; null if there is none of that type: for a number that is nil.
   */
  private byte @Nullable [] message(Topic topic, Outbox.Value value) {
    RosType type = program().ros() ? RosType.of(topic) : null;
    return type == null
        ? topic.message(value.time(), value.value())
        : type.message(topic, value.time(), value.value());
  }

  @Override
  public void channelWritabilityChanged(ChannelHandlerContext context) {
    if (context.channel().isWritable() && program != null) {
      tell(context.channel());
    }
  }

  private Program program() {
    return requireNonNull(program, "it has been let in");
  }

  // ------------------------------------------------------------------ what it wants

  @Override
  protected void received(Channel channel, WebSocketFrame frame) {
    try {
      if (frame instanceof TextWebSocketFrame) {
        obey(channel, Request.read(ByteBufUtil.getBytes(frame.content())));
      } else if (frame instanceof BinaryWebSocketFrame) {
        take(channel, frame.content());
      }
    } catch (BadMessage e) {
      send(channel, Answer.status(Answer.Level.ERROR, String.valueOf(e.getMessage())));
    }
  }

  private void obey(Channel channel, Request request) {
    Subscriptions subscriptions = program().subscriptions();
    switch (request) {
      case Request.Subscribe wish -> each(channel, wish.subscriptions(), subscriptions::subscribe);
      case Request.Unsubscribe wish ->
          each(channel, wish.subscriptions(), subscriptions::unsubscribe);
      case Request.Advertise wish -> each(channel, wish.channels(), this::offer);
      case Request.Unadvertise wish -> each(channel, wish.channels(), this::withdraw);
      case Request.GetParameters wish -> tellParameters(channel, wish.names(), wish.id());
      case Request.SetParameters wish -> set(channel, wish);
      case Request.WatchParameters wish ->
          each(channel, wish.names(), name -> subscriptions.watch(name, wish.on()));
    }
  }

  /** Part of a request. */
  @FunctionalInterface
  private interface Wish<T> {
    void fulfil(T what) throws BadMessage;
  }

  /** One part that makes no sense does not keep the others from being done. */
  private static <T> void each(Channel channel, List<T> parts, Wish<T> wish) {
    for (T part : parts) {
      try {
        wish.fulfil(part);
      } catch (BadMessage e) {
        send(channel, Answer.status(Answer.Level.ERROR, String.valueOf(e.getMessage())));
      }
    }
  }

  private void tellParameters(Channel channel, List<String> names, @Nullable String id) {
    List<String> wanted = names.isEmpty() ? program().subscriptions().parameterNames() : names;
    LateAnswers.take(
        channel,
        program().connection().values(wanted),
        values -> send(channel, Answer.parameterValues(wanted, values, id)));
  }

  private void set(Channel channel, Request.SetParameters wish) {
    List<CompletableFuture<?>> all = new ArrayList<>();
    for (Request.Parameter each : wish.parameters()) {
      all.add(give(channel, each.name(), each.value()));
    }
    if (wish.id() == null) {
      return;
    }
    LateAnswers.whenDone(
        channel,
        CompletableFuture.allOf(all.toArray(CompletableFuture[]::new)),
        (nothing, failure) ->
            tellParameters(
                channel,
                wish.parameters().stream().map(Request.Parameter::name).toList(),
                wish.id()));
  }

  private CompletableFuture<String> give(Channel channel, String path, @Nullable Object value) {
    return LateAnswers.take(
        channel,
        program().connection().give(path, value),
        error -> {
          if (!error.isEmpty()) {
            send(channel, Answer.status(Answer.Level.ERROR, path + ": " + error));
          }
        });
  }

  // ------------------------------------------------------------------ what it publishes

  private void offer(Request.Publication channel) throws BadMessage {
    if (!channel.encoding().equals(JSON)) {
      throw new BadMessage("encoding: json expected, not " + channel.encoding());
    }
    if (publications.size() == MOST_PUBLICATIONS) {
      throw new BadMessage("at most " + MOST_PUBLICATIONS + " channels of yours");
    }
    if (publications.putIfAbsent(channel.id(), channel) != null) {
      throw new BadMessage("there is a channel of that number: " + channel.id());
    }
  }

  private void withdraw(long id) throws BadMessage {
    if (publications.remove(id) == null) {
      throw new BadMessage("no such channel of yours: " + id);
    }
  }

  private void take(Channel channel, ByteBuf frame) throws BadMessage {
    byte what = frame.isReadable() ? frame.readByte() : 0;
    if (what == CALLED) {
      call(channel, frame);
    } else if (what == PUBLISHED && frame.readableBytes() >= Integer.BYTES) {
      publish(channel, frame);
    } else {
      throw new BadMessage("a message to a channel of yours expected, or a call of a service");
    }
  }

  private void call(Channel channel, ByteBuf frame) throws BadMessage {
    try {
      CallService.Call call = CallService.read(frame);
      LateAnswers.take(
          channel,
          program().connection().call(call.path(), call.arguments()),
          end ->
              send(
                  channel,
                  end.error().isEmpty()
                      ? Answer.called(call.id(), end.value())
                      : Answer.callFailure(CallService.ID, call.id(), end.error())));
    } catch (CallService.Failed e) {
      send(channel, Answer.callFailure(e.service(), e.call(), String.valueOf(e.getMessage())));
    }
  }

  /** A message is a value for the slot that its topic names: {@code {"value": 1}}, or whole. */
  private void publish(Channel channel, ByteBuf frame) throws BadMessage {
    long id = frame.readUnsignedIntLE();
    Request.Publication publication = publications.get(id);
    if (publication == null) {
      throw new BadMessage("no such channel of yours: " + id);
    }
    Map<String, @Nullable Object> content = Json.read(ByteBufUtil.getBytes(frame));
    boolean whole = content.size() != 1 || !content.containsKey("value");
    Object value = whole ? content : content.get("value");
    give(channel, Topic.path(publication.topic()), content.isEmpty() ? null : value);
  }

  @Override
  protected void left() {
    program().connection().close();
  }
}
