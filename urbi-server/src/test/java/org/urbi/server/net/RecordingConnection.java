package org.urbi.server.net;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.Connection;
import org.urbi.kernel.observe.CallEnd;
import org.urbi.kernel.observe.Media;
import org.urbi.kernel.observe.Proposal;
import org.urbi.kernel.observe.Sample;
import org.urbi.kernel.observe.Steering;
import org.urbi.kernel.observe.VariableListener;
import org.urbi.kernel.observe.View;
import org.urbi.kernel.observe.ViewRequest;
import org.urbi.kernel.trust.Role;

/** A lobby that only notes what is done to it, and has as much unread input as a test wants. */
final class RecordingConnection implements Connection {
  final List<String> calls = new ArrayList<>();
  int pending;

  /** How many times there will be no memory for what is sent. */
  int failures;

  /** How many requests of operators have come. */
  int requests;

  @Override
  public int number() {
    return 1;
  }

  @Override
  public void send(String bytes) {
    if (failures > 0) {
      failures--;
      throw new OutOfMemoryError("a test has none");
    }
    calls.add("send " + bytes);
  }

  @Override
  public void end() {
    calls.add("end");
  }

  @Override
  public void hangUp() {
    calls.add("hangUp");
  }

  @Override
  public long runningTurn() {
    return NO_TURN;
  }

  @Override
  public void close() {
    calls.add("close");
  }

  @Override
  public void failed(String where, Throwable failure) {
    throw new AssertionError(where, failure);
  }

  @Override
  public void giveRole(Role role) {
    calls.add("giveRole " + role.text());
  }

  @Override
  public void interrupt() {
    calls.add("interrupt");
  }

  @Override
  public int pendingInput() {
    return pending;
  }

  @Override
  public boolean incomplete() {
    return false;
  }

  @Override
  public CompletableFuture<List<String>> complete(String text) {
    throw new UnsupportedOperationException();
  }

  @Override
  public CompletableFuture<View> look(ViewRequest wanted) {
    throw new UnsupportedOperationException();
  }

  @Override
  public void lookNoMore() {
    throw new UnsupportedOperationException();
  }

  @Override
  public void lookAtEnd(Supplier<ViewRequest> wanted, Consumer<View> told) {
    throw new UnsupportedOperationException();
  }

  @Override
  public CompletableFuture<String> steer(Steering.Action action, boolean tag, long target) {
    throw new UnsupportedOperationException();
  }

  @Override
  public CompletableFuture<String> emit(long event, String payload) {
    throw new UnsupportedOperationException();
  }

  @Override
  public CompletableFuture<String> assign(String way, String value) {
    throw new UnsupportedOperationException();
  }

  @Override
  public CompletableFuture<List<Proposal>> propose(String text) {
    throw new UnsupportedOperationException();
  }

  @Override
  public CodeRun run(String file, String code) {
    throw new UnsupportedOperationException();
  }

  @Override
  public CompletableFuture<String> stop(int run) {
    throw new UnsupportedOperationException();
  }

  @Override
  public void open(String name, Runnable begin) {
    throw new UnsupportedOperationException();
  }

  @Override
  public void save(String name, String text, String version, Runnable begin) {
    throw new UnsupportedOperationException();
  }

  @Override
  public CompletableFuture<Sample> sample(List<String> ways) {
    throw new UnsupportedOperationException();
  }

  @Override
  public CompletableFuture<Optional<Media>> media(String way) {
    throw new UnsupportedOperationException();
  }

  @Override
  public void feed(VariableListener listener, boolean all, List<String> paths) {
    throw new UnsupportedOperationException();
  }

  @Override
  public void follow(int variable, boolean on) {
    throw new UnsupportedOperationException();
  }

  @Override
  public CompletableFuture<List<@Nullable Object>> values(List<String> paths) {
    throw new UnsupportedOperationException();
  }

  @Override
  public CompletableFuture<String> give(String path, @Nullable Object value) {
    throw new UnsupportedOperationException();
  }

  @Override
  public CompletableFuture<CallEnd> call(String path, List<@Nullable Object> arguments) {
    throw new UnsupportedOperationException();
  }

  @Override
  public String interrupt(String lobby) {
    requests++;
    return "asked for " + lobby;
  }
}
