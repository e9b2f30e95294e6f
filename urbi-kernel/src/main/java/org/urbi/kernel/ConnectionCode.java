package org.urbi.kernel;

import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.observe.CodeEnd;
import org.urbi.kernel.observe.RunningCode;
import org.urbi.kernel.trust.Role;

/** The texts that the client of a connection runs, each under a tag of its own. */
final class ConnectionCode {
  private final Kernel kernel;
  private final int number;
  private final Questions<CompletableFuture<CodeEnd>> awaited;
  private final Questions<CompletableFuture<String>> stopping;

  /** On the kernel thread. */
  private final Map<Integer, RunningCode> running = new HashMap<>();

  /**
   * @param number of the connection
   */
  ConnectionCode(Kernel kernel, int number) {
    this.kernel = kernel;
    this.number = number;
    this.awaited = new Questions<>(kernel.inbox(), end -> end.cancel(false));
    this.stopping = new Questions<>(kernel.inbox(), answer -> answer.cancel(false));
  }

  // ------------------------------------------------------------------ from any thread

  Connection.CodeRun run(String file, String code) {
    CompletableFuture<CodeEnd> end = new CompletableFuture<>();
    int run = awaited.ask(end, started -> new Message.CodeRun(number, started, file, code));
    return new Connection.CodeRun(run, name(run), end);
  }

  CompletableFuture<String> stop(int run) {
    CompletableFuture<String> answer = new CompletableFuture<>();
    stopping.ask(answer, question -> new Message.CodeStopped(number, question, run));
    return answer;
  }

  private static String name(int run) {
    return "run_" + run;
  }

  // ------------------------------------------------------------------ on the kernel thread

  void take(Message.OfCode message, UrbiLobby by) {
    if (message instanceof Message.CodeRun wanted) {
      begin(wanted, by);
    } else if (message instanceof Message.CodeStopped stopped) {
      stop(stopped);
    }
  }

  private void stop(Message.CodeStopped stopped) {
    RunningCode code = running.get(stopped.run());
    String error = "";
    if (code == null) {
      error = Problem.NO_SUCH_CODE.text(stopped.run());
    } else {
      code.stop();
    }
    CompletableFuture<String> answer = stopping.take(stopped.question());
    if (answer != null) {
      answer.complete(error);
    }
  }

  private void begin(Message.CodeRun wanted, UrbiLobby by) {
    if (by.role() == Role.OBSERVER) {
      String error = Problem.RUNS_NO_CODE.text(Role.USER.text(), by.role().text());
      told(wanted.run(), new CodeEnd(error, false));
      return;
    }
    running.values().removeIf(each -> !each.isThere());
    running.put(
        wanted.run(),
        new RunningCode(
            kernel.interpreter(),
            by,
            name(wanted.run()),
            wanted.file(),
            wanted.code(),
            end -> told(wanted.run(), end)));
  }

  /** In a replay nobody waits for it. */
  private void told(int run, CodeEnd end) {
    if (!end.goesOn()) {
      running.remove(run);
    }
    CompletableFuture<CodeEnd> awaiting = awaited.take(run);
    if (awaiting != null) {
      awaiting.complete(end);
    }
  }

  /** The connection is closed. */
  void close() {
    awaited.close();
    stopping.close();
    running.clear();
  }
}
