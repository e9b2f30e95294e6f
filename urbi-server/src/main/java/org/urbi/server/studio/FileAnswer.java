package org.urbi.server.studio;

import java.util.List;
import org.urbi.server.studio.files.SourceFiles;

/** What a browser is told of files, as JSON. */
final class FileAnswer {
  private FileAnswer() {}

  /** The names of files. */
  static String listed(long id, List<String> names) {
    return Answer.done(
        id,
        out -> {
          Answer.writeTexts(out, "files", names);
        });
  }

  /** What is in a file. */
  static String opened(long id, SourceFiles.Content content) {
    return Answer.done(
        id,
        out -> {
          out.writeStringField("text", content.text());
          out.writeStringField("version", content.version());
        });
  }

  /** A file has been written, and is of that version now. */
  static String saved(long id, String version) {
    return Answer.done(
        id,
        out -> {
          out.writeStringField("version", version);
        });
  }
}
