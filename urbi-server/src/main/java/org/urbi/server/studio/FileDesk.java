package org.urbi.server.studio;

import io.netty.channel.Channel;
import io.netty.handler.codec.http.websocketx.TextWebSocketFrame;
import java.util.concurrent.RejectedExecutionException;
import org.urbi.kernel.Connection;
import org.urbi.kernel.log.FailureLog;
import org.urbi.kernel.trust.Role;
import org.urbi.server.studio.access.LateAnswers;
import org.urbi.server.studio.files.FileRefused;
import org.urbi.server.studio.files.Folders;
import org.urbi.server.studio.files.SourceFiles;

/**
 * What a browser does with files, as far as its role has any. What it opens and saves goes by way
 * of the kernel, like all interventions.
 */
final class FileDesk {
  private final Channel channel;
  private final Connection connection;
  private final Role role;
  private final Folders folders;
  private final Worker worker;
  private boolean busy;

  /**
   * @param worker does it for all browsers, so that none changes a file between what another one
   *     looks at and what it writes
   */
  FileDesk(Channel channel, Connection connection, Role role, Folders folders, Worker worker) {
    this.channel = channel;
    this.connection = connection;
    this.role = role;
    this.folders = folders;
    this.worker = worker;
  }

  /** Does what is wanted; on the thread of the channel. */
  void obey(Request.OfFiles request) {
    if (busy) {
      send(Answer.done(request.id(), "one file after the other: wait for the answer"));
      return;
    }
    try {
      SourceFiles files = folders.of(role);
      busy = true;
      switch (request) {
        case Request.Files list -> begin(files, list);
        case Request.Open open -> connection.open(open.name(), () -> begin(files, open));
        case Request.Save save ->
            connection.save(save.name(), save.text(), save.version(), () -> begin(files, save));
      }
    } catch (FileRefused e) {
      send(Answer.done(request.id(), reason(e)));
    }
  }

  private void begin(SourceFiles files, Request.OfFiles request) {
    LateAnswers.whenDone(
        channel,
        worker.ask(() -> answer(files, request)),
        (answer, failure) -> {
          busy = false;
          send(failure != null ? Answer.done(request.id(), reason(failure)) : answer);
        });
  }

  private static String answer(SourceFiles files, Request.OfFiles request) throws FileRefused {
    return switch (request) {
      case Request.Files list -> FileAnswer.listed(list.id(), files.list());
      case Request.Open open -> FileAnswer.opened(open.id(), files.open(open.name()));
      case Request.Save save ->
          FileAnswer.saved(save.id(), files.save(save.name(), save.text(), save.version()));
    };
  }

  private static String reason(Throwable failure) {
    if (failure instanceof FileRefused refused) {
      return String.valueOf(refused.getMessage());
    }
    if (failure instanceof RejectedExecutionException) {
      return "nobody is served any more";
    }
    FailureLog.internal("the files of the studio", failure);
    return FailureLog.text(failure);
  }

  private void send(String text) {
    channel.writeAndFlush(new TextWebSocketFrame(text));
  }
}
