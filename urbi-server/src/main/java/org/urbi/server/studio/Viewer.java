package org.urbi.server.studio;

import static java.util.Objects.requireNonNull;

import io.netty.channel.Channel;
import io.netty.channel.ChannelHandlerContext;
import io.netty.handler.codec.http.websocketx.TextWebSocketFrame;
import io.netty.handler.codec.http.websocketx.WebSocketFrame;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.Client;
import org.urbi.kernel.Connection;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.observe.View;
import org.urbi.kernel.observe.ViewRequest;
import org.urbi.kernel.trust.Role;
import org.urbi.lang.grammar.Keywords;
import org.urbi.server.Version;
import org.urbi.server.studio.access.Admission;
import org.urbi.server.studio.access.LateAnswers;
import org.urbi.server.studio.access.PageClient;
import org.urbi.server.studio.access.StreamHandler;
import org.urbi.server.studio.files.Folders;
import org.urbi.server.studio.messages.JobTable;
import org.urbi.web.Annexes;
import org.urbi.web.Downloads;

/**
 * A browser. When it has been let in, it has a connection to the kernel, with a lobby whose role is
 * what it may do. Only when it has read what it was sent, the kernel is asked what has changed
 * since.
 */
final class Viewer extends StreamHandler {
  /** How many requests may come at once, and in each second. */
  private static final int MOST_REQUESTS = 40;

  private final Function<Client, Connection> lobbies;
  private final SyntaxCheck syntax;
  private final Folders folders;
  private final Worker fileWorker;
  private final Annexes annexes;
  private final RecordedFiles recorded;
  private final Downloads downloads;
  private final String instance;
  private final List<Runnable> notListening = new ArrayList<>();
  private @Nullable Connection connection;
  private @Nullable Sampler sampler;
  private @Nullable MediaDesk media;
  private @Nullable CodeDesk desk;
  private @Nullable FileDesk files;
  private @Nullable RecordingDesk recordings;
  private ViewRequest wanted = new ViewRequest(0, List.of(), null, null);
  private boolean looking;
  private boolean due;

  Viewer(
      Admission admission,
      Function<Client, Connection> lobbies,
      SyntaxCheck syntax,
      Folders folders,
      Worker fileWorker,
      Annexes annexes,
      RecordedFiles recorded,
      Downloads downloads,
      String instance) {
    super(admission, MOST_REQUESTS);
    this.lobbies = lobbies;
    this.syntax = syntax;
    this.folders = folders;
    this.fileWorker = fileWorker;
    this.annexes = annexes;
    this.recorded = recorded;
    this.downloads = downloads;
    this.instance = instance;
  }

  // ------------------------------------------------------------------ who it is

  @Override
  protected void admitted(Channel channel, Role role, String uri) {
    connection =
        lobbies.apply(
            new PageClient(
                channel,
                role,
                bytes ->
                    channel.writeAndFlush(
                        new TextWebSocketFrame(Answer.text("output", Utf8Text.toJava(bytes))))));
    sampler = new Sampler(channel, connection);
    media = new MediaDesk(channel, connection);
    desk = new CodeDesk(channel, connection, syntax);
    files = new FileDesk(channel, connection, role, folders, fileWorker);
    List<String> keywords = Keywords.all().stream().sorted().toList();
    send(channel, Answer.hello(role.text(), Version.number(), instance, keywords));
    tell(annexes::listen, () -> send(channel, Answer.worlds(annexes.all())));
    recordings = new RecordingDesk(channel, role, recorded, fileWorker, downloads);
    tell(recorded::listen, recordings::tell);
    look(channel);
  }

  @Override
  protected WebSocketFrame refusal(String reason, int again) {
    return new TextWebSocketFrame(Answer.refused(reason, again));
  }

  // ------------------------------------------------------------------ what it is told

  /** Tells something now, and whenever it has changed. */
  private void tell(UnaryOperator<Runnable> listen, Runnable telling) {
    notListening.add(listen.apply(telling));
    telling.run();
  }

  /** Asks the kernel what has changed, unless the browser has not read what it was told before. */
  private void look(Channel channel) {
    if (!channel.isActive() || looking) {
      return;
    }
    due = !channel.isWritable();
    if (!due) {
      looking = true;
      LateAnswers.take(channel, connection().look(wanted), view -> show(channel, view));
    }
  }

  private void show(Channel channel, View view) {
    looking = false;
    if (!view.isVoid()) {
      send(channel, Answer.view(view));
    }
    if (view.complete()) {
      Runnable next = LateAnswers.guarding(channel, () -> look(channel));
      channel.eventLoop().schedule(next, JobTable.pause(view), TimeUnit.MILLISECONDS);
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
    if (media != null) {
      media.fetch();
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

  private CodeDesk desk() {
    return requireNonNull(desk, "it has been let in");
  }

  // ------------------------------------------------------------------ what it wants

  @Override
  protected void received(Channel channel, WebSocketFrame frame) {
    if (frame instanceof TextWebSocketFrame text) {
      try {
        obey(channel, Request.read(text.text()));
      } catch (BadRequest e) {
        send(channel, e.answer());
      }
    } else {
      send(channel, Answer.text("error", "text expected"));
    }
  }

  private void obey(Channel channel, Request request) {
    switch (request) {
      case Request.Interest interest ->
          wanted =
              new ViewRequest(
                  interest.selected(), interest.traced(), wanted.reactions(), wanted.objects());
      case Request.Reactions reactions ->
          wanted =
              new ViewRequest(
                  wanted.selected(), wanted.traced(), reactions.filter(), wanted.objects());
      case Request.Variables variables ->
          wanted =
              new ViewRequest(
                  wanted.selected(), wanted.traced(), wanted.reactions(), variables.objects());
      case Request.Plot plot -> sampler().plot(plot);
      case Request.Show show -> requireNonNull(media, "it has been let in").obey(show);
      case Request.Assign assign ->
          tell(channel, assign.id(), connection().assign(assign.way(), assign.value()));
      case Request.Steer steer ->
          tell(
              channel, steer.id(), connection().steer(steer.action(), steer.tag(), steer.target()));
      case Request.Emit emit ->
          tell(channel, emit.id(), connection().emit(emit.event(), emit.payload()));
      case Request.Download wish -> requireNonNull(recordings, "it has been let in").obey(wish);
      case Request.OfCode wish -> desk().obey(wish);
      case Request.OfFiles wish -> requireNonNull(files, "it has been let in").obey(wish);
    }
  }

  /** Tells what has become of an intervention, when it is known. */
  private static void tell(Channel channel, long id, CompletableFuture<String> outcome) {
    LateAnswers.take(channel, outcome, error -> send(channel, Answer.done(id, error)));
  }

  @Override
  protected void left() {
    notListening.forEach(Runnable::run);
    connection().close();
  }
}
