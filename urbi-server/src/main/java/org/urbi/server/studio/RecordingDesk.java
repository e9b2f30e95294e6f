package org.urbi.server.studio;

import io.netty.channel.Channel;
import io.netty.handler.codec.http.websocketx.TextWebSocketFrame;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.urbi.kernel.trust.Role;
import org.urbi.server.studio.RecordedFiles.Recording;
import org.urbi.server.studio.access.LateAnswers;
import org.urbi.web.Downloads;

/** What a browser is told of the files to which variables are recorded, and how it gets them. */
final class RecordingDesk {
  private final Channel channel;
  private final Role role;
  private final RecordedFiles recorded;
  private final Worker worker;
  private final Downloads downloads;

  /**
   * @param worker looks whether a file is there
   */
  RecordingDesk(
      Channel channel, Role role, RecordedFiles recorded, Worker worker, Downloads downloads) {
    this.channel = channel;
    this.role = role;
    this.recorded = recorded;
    this.worker = worker;
    this.downloads = downloads;
  }

  /** Tells what is recorded, and what was, to whom may have it. */
  void tell() {
    List<Recording> finished = role == Role.OWNER ? recorded.finished() : List.of();
    send(Answer.recording(recorded.current(), finished));
  }

  /** Offers a file for download; on the thread of the channel. */
  void obey(Request.Download wish) {
    if (role != Role.OWNER) {
      send(Answer.done(wish.id(), "only an owner may download recordings"));
      return;
    }
    Recording current = recorded.current();
    if (current != null && current.number() == wish.recording()) {
      send(Answer.done(wish.id(), current.path() + " is still being written: stop it first"));
      return;
    }
    recorded.finished().stream()
        .filter(each -> each.number() == wish.recording())
        .findFirst()
        .ifPresentOrElse(
            found -> offer(wish, found.path()),
            () -> send(Answer.done(wish.id(), "this recording was overwritten, or is too old")));
  }

  private void offer(Request.Download wish, Path file) {
    CompletableFuture<Boolean> readable =
        worker.ask(() -> Files.isRegularFile(file) && Files.isReadable(file));
    LateAnswers.take(
        channel,
        readable,
        there ->
            send(
                there
                    ? Answer.offered(wish.id(), downloads.offer(file))
                    : Answer.done(wish.id(), file + " is not there any more")));
  }

  private void send(String text) {
    channel.writeAndFlush(new TextWebSocketFrame(text));
  }
}
