package org.urbi.server.studio;

import static java.util.Objects.requireNonNull;

import io.netty.channel.Channel;
import io.netty.channel.ChannelFutureListener;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.SimpleChannelInboundHandler;
import io.netty.handler.codec.http.QueryStringDecoder;
import io.netty.handler.codec.http.websocketx.PongWebSocketFrame;
import io.netty.handler.codec.http.websocketx.TextWebSocketFrame;
import io.netty.handler.codec.http.websocketx.WebSocketFrame;
import io.netty.handler.codec.http.websocketx.WebSocketServerProtocolHandler.HandshakeComplete;
import io.netty.util.concurrent.ScheduledFuture;
import java.net.InetSocketAddress;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.Client;
import org.urbi.kernel.Connection;
import org.urbi.kernel.observe.Look;
import org.urbi.kernel.observe.View;
import org.urbi.kernel.trust.Role;
import org.urbi.server.Trace;
import org.urbi.server.Version;
import org.urbi.server.trust.AccessPolicy;
import org.urbi.server.trust.TokenThrottle;
import org.urbi.server.trust.Tokens;

/**
 * A browser. When it has been let in, it has a connection to the kernel, with a lobby whose role is
 * what it may do. Only when it has read what it was sent, the kernel is asked what has changed
 * since.
 */
final class Viewer extends SimpleChannelInboundHandler<WebSocketFrame> {
  /** Between two rounds over the jobs, in milliseconds. */
  private static final int PERIOD = 250;

  /** How many requests may come at once, and in each second. */
  private static final int MOST_REQUESTS = 40;

  /** How much output of the lobby may wait; more is left out. */
  private static final int MOST_OUTPUT = 1 << 18;

  private final AccessPolicy accessPolicy;
  private final TokenThrottle wrong;
  private final Function<Client, Connection> lobbies;
  private final Trace trace;
  private @Nullable Connection connection;
  private @Nullable Sampler sampler;
  private Look wanted = new Look(0, List.of(), null, null);
  private boolean looking;
  private boolean due;
  private boolean refused;
  private int requests;
  private @Nullable ScheduledFuture<?> pause;

  Viewer(
      AccessPolicy accessPolicy,
      TokenThrottle wrong,
      Function<Client, Connection> lobbies,
      Trace trace) {
    this.accessPolicy = accessPolicy;
    this.wrong = wrong;
    this.lobbies = lobbies;
    this.trace = trace;
  }

  // ------------------------------------------------------------------ who it is

  @Override
  public void userEventTriggered(ChannelHandlerContext context, Object event) {
    if (event instanceof HandshakeComplete done) {
      List<String> tokens =
          new QueryStringDecoder(done.requestUri()).parameters().getOrDefault("token", List.of());
      Channel channel = context.channel();
      if (tokens.isEmpty()) {
        admit(channel, accessPolicy.defaultRole());
      } else {
        shown(channel, tokens.getFirst());
      }
    }
  }

  private void shown(Channel channel, String token) {
    String address = ((InetSocketAddress) channel.remoteAddress()).getAddress().getHostAddress();
    long wait = wrong.secondsToWait(address);
    if (!accessPolicy.asks()) {
      admit(channel, accessPolicy.defaultRole());
    } else if (wait > 0) {
      refuse(channel, "after a wrong token, no other one for " + wait + " s");
    } else {
      Tokens.TokenHolder holder = accessPolicy.holder(token);
      if (holder == null) {
        wrong.recordFailure(address);
        trace.log("studio: wrong token: " + channel.remoteAddress());
        refuse(channel, "wrong token");
      } else {
        wrong.recordSuccess(address);
        admit(channel, holder.role());
      }
    }
  }

  private void admit(Channel channel, @Nullable Role role) {
    if (role == null) {
      refuse(channel, "this server asks for a token: put ?token=TOKEN behind the address");
      return;
    }
    connection = lobbies.apply(new Lobby(channel, role));
    sampler = new Sampler(channel, connection);
    send(channel, Answer.hello(role.text(), Version.number()));
    pause =
        channel
            .eventLoop()
            .scheduleAtFixedRate(
                () -> requests = Math.max(0, requests - MOST_REQUESTS), 1, 1, TimeUnit.SECONDS);
    look(channel);
  }

  private void refuse(Channel channel, String reason) {
    refused = true;
    channel
        .writeAndFlush(new TextWebSocketFrame(Answer.text("refused", reason)))
        .addListener(ChannelFutureListener.CLOSE);
  }

  // ------------------------------------------------------------------ what it is told

  /** Asks the kernel what has changed, unless the browser has not read what it was told before. */
  private void look(Channel channel) {
    if (!channel.isActive() || looking) {
      return;
    }
    due = !channel.isWritable();
    if (!due) {
      looking = true;
      connection()
          .look(wanted)
          .whenCompleteAsync((view, failure) -> show(channel, view), channel.eventLoop());
    }
  }

  private void show(Channel channel, @Nullable View view) {
    looking = false;
    if (view == null) {
      // The kernel has closed the connection.
      return;
    }
    send(channel, Answer.view(view));
    if (view.complete()) {
      channel.eventLoop().schedule(() -> look(channel), PERIOD, TimeUnit.MILLISECONDS);
    } else {
      look(channel);
    }
  }

  @Override
  public void channelWritabilityChanged(ChannelHandlerContext context) {
    if (context.channel().isWritable() && due) {
      look(context.channel());
    }
    if (sampler != null) {
      sampler.sample();
    }
  }

  private static void send(Channel channel, String text) {
    channel.writeAndFlush(new TextWebSocketFrame(text));
  }

  private Connection connection() {
    return requireNonNull(connection, "it has been let in");
  }

  private Sampler sampler() {
    return requireNonNull(sampler, "it has been let in");
  }

  // ------------------------------------------------------------------ what it wants

  @Override
  protected void channelRead0(ChannelHandlerContext context, WebSocketFrame frame) {
    Channel channel = context.channel();
    if (refused || connection == null || frame instanceof PongWebSocketFrame) {
      return;
    }
    if (!(frame instanceof TextWebSocketFrame text)) {
      send(channel, Answer.text("error", "text expected"));
    } else if (++requests > MOST_REQUESTS * 2) {
      refuse(channel, "too many requests: at most " + MOST_REQUESTS + " in a second");
    } else {
      try {
        obey(channel, Request.read(text.text()));
      } catch (BadRequest e) {
        send(channel, Answer.text("error", String.valueOf(e.getMessage())));
      }
    }
  }

  private void obey(Channel channel, Request request) {
    switch (request) {
      case Request.Interest interest ->
          wanted =
              new Look(
                  interest.selected(), interest.traced(), wanted.reactions(), wanted.objects());
      case Request.Reactions reactions ->
          wanted =
              new Look(wanted.selected(), wanted.traced(), reactions.filter(), wanted.objects());
      case Request.Variables variables ->
          wanted =
              new Look(wanted.selected(), wanted.traced(), wanted.reactions(), variables.objects());
      case Request.Plot plot -> sampler().plot(plot);
      case Request.Show show ->
          connection()
              .media(show.way())
              .whenCompleteAsync(
                  (media, failure) -> {
                    if (media != null) {
                      send(channel, VariableAnswer.shown(show.id(), media));
                    }
                  },
                  channel.eventLoop());
      case Request.Assign assign ->
          tell(channel, assign.id(), connection().assign(assign.way(), assign.value()));
      case Request.Steer steer ->
          tell(
              channel, steer.id(), connection().steer(steer.action(), steer.tag(), steer.target()));
      case Request.Emit emit ->
          tell(channel, emit.id(), connection().emit(emit.event(), emit.payload()));
    }
  }

  /** Tells what has become of an intervention, when it is known. */
  private static void tell(Channel channel, long id, CompletableFuture<String> outcome) {
    outcome.whenCompleteAsync(
        (error, failure) -> {
          if (error != null) {
            send(channel, Answer.done(id, error));
          }
        },
        channel.eventLoop());
  }

  @Override
  public void channelInactive(ChannelHandlerContext context) {
    if (pause != null) {
      pause.cancel(false);
    }
    if (connection != null) {
      connection.close();
    }
  }

  @Override
  public void exceptionCaught(ChannelHandlerContext context, Throwable cause) {
    // A broken connection, or a message that is too long: the others are not concerned.
    context.close();
  }

  /** The client of the lobby; called on the kernel thread. */
  private static final class Lobby implements Client {
    private final Channel channel;
    private final Role role;
    private final AtomicInteger waiting = new AtomicInteger();

    Lobby(Channel channel, Role role) {
      this.channel = channel;
      this.role = role;
    }

    @Override
    public void output(String bytes) {
      int length = bytes.length();
      if (waiting.addAndGet(length) > MOST_OUTPUT) {
        waiting.addAndGet(-length);
        return;
      }
      execute(() ->
          channel
              .writeAndFlush(new TextWebSocketFrame(Answer.text("output", bytes)))
              .addListener(written -> waiting.addAndGet(-length)));
    }

    @Override
    public void closed() {
      execute(channel::close);
    }

    private void execute(Runnable work) {
      try {
        channel.eventLoop().execute(work);
      } catch (RejectedExecutionException e) {
        // The studio has been closed.
      }
    }

    @Override
    public long unread() {
      return waiting.get();
    }

    @Override
    public Role role() {
      return role;
    }

    @Override
    public String remoteAddress() {
      return ((InetSocketAddress) channel.remoteAddress()).getAddress().getHostAddress();
    }
  }
}
