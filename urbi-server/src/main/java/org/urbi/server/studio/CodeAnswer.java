package org.urbi.server.studio;

import java.util.List;
import org.urbi.kernel.Connection;
import org.urbi.kernel.observe.CodeEnd;
import org.urbi.kernel.observe.Proposal;

/** What a browser is told of the code that people write there, as JSON. */
final class CodeAnswer {
  private CodeAnswer() {}

  /** A text runs from now on, with a number by which it can be stopped, under a tag. */
  static String begun(long id, Connection.CodeRun run) {
    return Answer.object(
        "begun",
        out -> {
          out.writeNumberField("id", id);
          out.writeNumberField("run", run.number());
          out.writeStringField("tag", run.tag());
        });
  }

  /** A text has ended. */
  static String ended(long id, CodeEnd end) {
    return Answer.done(id, end.error(), out -> out.writeBooleanField("goesOn", end.goesOn()));
  }

  /** What is wrong in a text, by the numbers of its characters. */
  static String mistakes(long id, List<SyntaxCheck.Mistake> mistakes) {
    return Answer.done(
        id,
        out -> {
          out.writeArrayFieldStart("mistakes");
          for (SyntaxCheck.Mistake mistake : mistakes) {
            out.writeStartObject();
            out.writeNumberField("begin", mistake.begin());
            out.writeNumberField("end", mistake.end());
            out.writeStringField("text", mistake.text());
            out.writeEndObject();
          }
          out.writeEndArray();
        });
  }

  /** What somebody may be about to type. */
  static String proposals(long id, List<Proposal> proposals) {
    return Answer.done(
        id,
        out -> {
          out.writeArrayFieldStart("proposals");
          for (Proposal proposal : proposals) {
            out.writeStartObject();
            out.writeStringField("name", proposal.name());
            out.writeStringField("signature", proposal.signature());
            out.writeStringField("doc", proposal.doc());
            out.writeEndObject();
          }
          out.writeEndArray();
        });
  }
}
