package org.urbi.server.studio;

import io.netty.channel.Channel;
import io.netty.handler.codec.http.websocketx.TextWebSocketFrame;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import org.urbi.kernel.Connection;
import org.urbi.server.studio.access.LateAnswers;

/** What a browser does with code: runs and stops it, has it checked and completed. */
final class CodeDesk {
  /** How long code that is to end may hold the kernel before it is interrupted, in milliseconds. */
  private static final int PATIENCE = 200;

  private final Channel channel;
  private final Connection connection;
  private final SyntaxCheck syntax;
  private boolean checking;

  CodeDesk(Channel channel, Connection connection, SyntaxCheck syntax) {
    this.channel = channel;
    this.connection = connection;
    this.syntax = syntax;
  }

  /** Does what is wanted; on the thread of the channel. */
  void obey(Request.OfCode request) {
    switch (request) {
      case Request.Run run -> run(run);
      case Request.Stop stop -> stop(stop);
      case Request.Check check -> check(check);
      case Request.Complete wanted ->
          LateAnswers.take(
              channel,
              connection.propose(wanted.text()),
              found -> send(CodeAnswer.proposals(wanted.id(), found)));
    }
  }

  private void run(Request.Run request) {
    Connection.CodeRun run = connection.run(request.file(), request.code());
    send(CodeAnswer.begun(request.id(), run));
    LateAnswers.take(channel, run.end(), end -> send(CodeAnswer.ended(request.id(), end)));
  }

  /** Code that never lets others run would not be reached by the wish to end it. */
  private void stop(Request.Stop request) {
    Runnable interrupt = LateAnswers.guarding(channel, connection::interrupt);
    Future<?> interruption =
        channel.eventLoop().schedule(interrupt, PATIENCE, TimeUnit.MILLISECONDS);
    CompletableFuture<String> stopped = connection.stop(request.run());
    LateAnswers.whenDone(channel, stopped, (error, failure) -> interruption.cancel(false));
    LateAnswers.take(channel, stopped, error -> send(Answer.done(request.id(), error)));
  }

  private void check(Request.Check request) {
    if (checking) {
      send(Answer.done(request.id(), "one text is checked at a time: wait for the answer"));
      return;
    }
    checking = true;
    LateAnswers.whenDone(
        channel,
        syntax.check(request.code()),
        (mistakes, failure) -> {
          checking = false;
          send(
              failure != null
                  ? Answer.done(request.id(), SyntaxCheck.reason(failure))
                  : CodeAnswer.mistakes(request.id(), mistakes));
        });
  }

  private void send(String text) {
    channel.writeAndFlush(new TextWebSocketFrame(text));
  }
}
