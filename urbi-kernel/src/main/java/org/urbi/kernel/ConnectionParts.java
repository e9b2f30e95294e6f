package org.urbi.kernel;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.observe.CallEnd;
import org.urbi.kernel.observe.Media;
import org.urbi.kernel.observe.Proposal;
import org.urbi.kernel.observe.Sample;
import org.urbi.kernel.observe.Steering;
import org.urbi.kernel.observe.VariableListener;
import org.urbi.kernel.observe.View;
import org.urbi.kernel.observe.ViewRequest;

/**
 * What a connection offers besides its shell: completions, views of what runs, variables, code and
 * files, each by a part of its own.
 */
abstract class ConnectionParts implements Connection {
  final Kernel kernel;
  final int number;
  private final ConnectionView view;
  private final ConnectionFeed feed;
  private final ConnectionCode code;
  private final ConnectionFiles files;
  private final ConnectionCompletions completions;

  ConnectionParts(Kernel kernel, int number) {
    this.kernel = kernel;
    this.number = number;
    view = new ConnectionView(kernel, number);
    feed = new ConnectionFeed(kernel, number);
    code = new ConnectionCode(kernel, number);
    files = new ConnectionFiles(kernel, number);
    completions = new ConnectionCompletions(kernel, number);
  }

  /** Its lobby, once it is open. */
  abstract UrbiLobby lobby();

  /** Whether it has been closed, so that nobody answers any more; from any thread. */
  abstract boolean isGone();

  // ------------------------------------------------------------------ from any thread

  @Override
  public int number() {
    return number;
  }

  @Override
  public CompletableFuture<List<String>> complete(String text) {
    return completions.ask(text, isGone());
  }

  @Override
  public CompletableFuture<List<Proposal>> propose(String text) {
    return view.propose(this::lobby, text);
  }

  @Override
  public CompletableFuture<View> look(ViewRequest wanted) {
    return view.look(wanted);
  }

  @Override
  public void lookNoMore() {
    view.lookNoMore();
  }

  @Override
  public void lookAtEnd(Supplier<ViewRequest> wanted, Consumer<View> told) {
    view.lookAtEnd(wanted, told);
  }

  @Override
  public CompletableFuture<String> steer(Steering.Action action, boolean tag, long target) {
    return view.steer(action, tag, target);
  }

  @Override
  public CompletableFuture<String> emit(long event, String payload) {
    return view.emit(event, payload);
  }

  @Override
  public CompletableFuture<String> assign(String way, String value) {
    return view.assign(way, value);
  }

  @Override
  public CodeRun run(String file, String text) {
    return code.run(file, text);
  }

  @Override
  public CompletableFuture<String> stop(int run) {
    return code.stop(run);
  }

  @Override
  public void open(String name, Runnable begin) {
    files.open(name, begin);
  }

  @Override
  public void save(String name, String text, String version, Runnable begin) {
    files.save(name, text, version, begin);
  }

  @Override
  public CompletableFuture<Sample> sample(List<String> ways) {
    return view.sample(ways);
  }

  @Override
  public CompletableFuture<Optional<Media>> media(String way) {
    return view.media(way);
  }

  @Override
  public void feed(VariableListener listener, boolean all, List<String> paths) {
    feed.begin(listener, all, paths);
  }

  @Override
  public void follow(int variable, boolean on) {
    kernel.inbox().post(new Message.Followed(number, variable, on));
  }

  @Override
  public CompletableFuture<List<@Nullable Object>> values(List<String> paths) {
    return feed.values(paths);
  }

  @Override
  public CompletableFuture<String> give(String path, @Nullable Object value) {
    return feed.give(path, value);
  }

  @Override
  public CompletableFuture<CallEnd> call(String path, List<@Nullable Object> arguments) {
    return feed.call(path, arguments);
  }

  // ------------------------------------------------------------------ on the kernel thread

  /** Takes a request for completions; there are none of a lobby that is over. */
  void takeCompletion(Message.CompletionRequested asked, @Nullable UrbiLobby of) {
    completions.take(asked, of);
  }

  /** Takes a message to one of the parts; false if it is to none. */
  boolean takePart(Message message) {
    // No pattern switch: the JDK links one anew in each process, which would slow down short
    // scripts.
    if (message instanceof Message.LookedAt looked) {
      view.take(looked);
    } else if (message instanceof Message.LookEnded) {
      view.endLook();
    } else if (message instanceof Message.Steered steered) {
      view.take(steered, lobby());
    } else if (message instanceof Message.Emitted emitted) {
      view.take(emitted, lobby());
    } else if (message instanceof Message.Assigned assigned) {
      view.take(assigned, lobby());
    } else if (message instanceof Message.OfVariables wish) {
      feed.take(wish, lobby());
    } else if (message instanceof Message.OfCode wish) {
      code.take(wish, lobby());
    } else if (message instanceof Message.OfFiles wish) {
      files.take(wish);
    } else {
      return false;
    }
    return true;
  }

  /** Another connection has been opened, with a lobby. */
  void lobbyOpened() {
    feed.lobbyOpened();
  }

  /** The kernel is about to end. */
  void lookLast() {
    view.lookLast();
  }

  /** Nobody looks any more. */
  void closeParts() {
    view.close();
    feed.close();
    code.close();
    files.close();
  }

  /** No more completions are asked for. */
  void closeCompletions() {
    completions.close();
  }
}
