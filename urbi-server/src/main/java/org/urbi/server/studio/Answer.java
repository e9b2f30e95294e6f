package org.urbi.server.studio;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Turn;
import org.urbi.kernel.observe.JobDetail;
import org.urbi.kernel.observe.JobRow;
import org.urbi.kernel.observe.ReactionView;
import org.urbi.kernel.observe.TagRow;
import org.urbi.kernel.observe.TurnView;
import org.urbi.kernel.observe.VariableView;
import org.urbi.kernel.observe.View;
import org.urbi.server.studio.RecordedFiles.Recording;
import org.urbi.web.Annex;

/** What a browser is told, as JSON. */
final class Answer {
  private static final JsonFactory JSON = new JsonFactory();
  static final double MILLISECOND = 1e6;

  @FunctionalInterface
  interface Content {
    void write(JsonGenerator out) throws IOException;
  }

  private Answer() {}

  /**
   * The first thing that a browser is told.
   *
   * @param instance of another server it is another one: numbers mean something else there
   */
  static String hello(String role, String version, String instance, List<String> keywords) {
    return object(
        "hello",
        out -> {
          out.writeStringField("role", role);
          out.writeStringField("version", version);
          out.writeStringField("instance", instance);
          out.writeNumberField("longest", Request.LONGEST);
          writeTexts(out, "keywords", keywords);
        });
  }

  /** The simulated worlds whose pages can be shown, by the names of their components. */
  static String worlds(Map<String, Annex> annexes) {
    return object(
        "worlds",
        out -> {
          out.writeArrayFieldStart("worlds");
          for (Map.Entry<String, Annex> each : annexes.entrySet()) {
            out.writeStartObject();
            out.writeStringField("name", each.getKey());
            out.writeStringField("title", each.getValue().title());
            out.writeEndObject();
          }
          out.writeEndArray();
        });
  }

  /**
   * To which file variables are being recorded, empty if to none, and those that can be downloaded.
   */
  static String recording(@Nullable Recording current, List<Recording> finished) {
    return object(
        "recording",
        out -> {
          out.writeStringField("file", current == null ? "" : current.path().toString());
          out.writeArrayFieldStart("finished");
          for (Recording each : finished) {
            out.writeStartObject();
            out.writeNumberField("number", each.number());
            out.writeStringField("file", each.path().toString());
            out.writeEndObject();
          }
          out.writeEndArray();
        });
  }

  /** A file can be fetched at an address. */
  static String offered(long id, String address) {
    return done(id, out -> out.writeStringField("address", address));
  }

  /** Some text for people: an {@code error}, or {@code output}. */
  static String text(String type, String text) {
    return object(type, out -> out.writeStringField("text", text));
  }

  /**
   * The reason for which it is not let in, or not any more.
   *
   * @param again after how many seconds it may be worth to come again; 0 if it is of no use
   */
  static String refused(String reason, int again) {
    return object(
        "refused",
        out -> {
          out.writeStringField("text", reason);
          out.writeNumberField("again", again);
        });
  }

  /** What became of a request: an error, or nothing when all went well. */
  static String done(long id, String error) {
    return done(id, error, out -> {});
  }

  /** A request went well, and gave this. */
  static String done(long id, Content result) {
    return done(id, "", result);
  }

  /** What became of a request, and more. */
  static String done(long id, String error, Content result) {
    return object(
        "done",
        out -> {
          out.writeNumberField("id", id);
          out.writeStringField("error", error);
          result.write(out);
        });
  }

  /** What has changed. Times are in milliseconds. */
  static String view(View view) {
    return object(
        "view",
        out -> {
          out.writeNumberField("machine", view.machine() / MILLISECOND);
          out.writeNumberField("time", view.time() / MILLISECOND);
          out.writeNumberField("total", view.total());
          out.writeBooleanField("complete", view.complete());
          out.writeArrayFieldStart("jobs");
          for (JobRow job : view.jobs()) {
            write(out, job);
          }
          out.writeEndArray();
          write(out, "gone", view.gone());
          out.writeArrayFieldStart("tags");
          for (TagRow tag : view.tags()) {
            out.writeStartObject();
            out.writeNumberField("number", tag.number());
            out.writeStringField("name", tag.name());
            out.writeBooleanField("frozen", tag.frozen());
            out.writeBooleanField("blocked", tag.blocked());
            out.writeEndObject();
          }
          out.writeEndArray();
          write(out, "tagsGone", view.tagsGone());
          write(out, view.turns());
          JobDetail detail = view.detail();
          if (detail != null) {
            out.writeFieldName("detail");
            write(out, detail);
          }
          ReactionView reactions = view.reactions();
          if (reactions != null) {
            out.writeFieldName("reactions");
            ReactionAnswer.write(out, reactions);
          }
          VariableView variables = view.variables();
          if (variables != null) {
            out.writeFieldName("variables");
            VariableAnswer.write(out, variables);
          }
        });
  }

  private static void write(JsonGenerator out, JobRow job) throws IOException {
    out.writeStartObject();
    out.writeNumberField("number", job.number());
    out.writeStringField("name", job.name());
    out.writeNumberField("starter", job.starter());
    out.writeStringField("lobby", job.lobby());
    out.writeStringField("waits", job.waits());
    out.writeBooleanField("frozen", job.frozen());
    out.writeStringField("place", job.place());
    out.writeStringField("code", job.code());
    write(out, "tags", job.tags());
    out.writeNumberField("share", job.share());
    out.writeEndObject();
  }

  private static void write(JsonGenerator out, TurnView turning) throws IOException {
    out.writeArrayFieldStart("turns");
    for (Turn turn : turning.turns()) {
      write(out, turn);
    }
    out.writeEndArray();
    if (turning.lostUntil() != 0) {
      out.writeNumberField("lostUntil", turning.lostUntil() / MILLISECOND);
    }
    Map<Long, Long> traced = turning.traced();
    if (traced != null) {
      out.writeArrayFieldStart("traced");
      for (Map.Entry<Long, Long> each : traced.entrySet()) {
        out.writeStartArray();
        out.writeNumber(each.getKey());
        out.writeNumber(each.getValue() / MILLISECOND);
        out.writeEndArray();
      }
      out.writeEndArray();
    }
  }

  /** A turn, as a list: there are very many of them. */
  private static void write(JsonGenerator out, Turn turn) throws IOException {
    out.writeStartArray();
    out.writeNumber(turn.job());
    out.writeStartArray();
    for (long waker : turn.wakers()) {
      out.writeNumber(waker);
    }
    out.writeEndArray();
    out.writeNumber(turn.begin() / MILLISECOND);
    out.writeNumber(turn.end() / MILLISECOND);
    out.writeString(turn.before().text());
    out.writeNumber(turn.ended() ? 1 : 0);
    out.writeEndArray();
  }

  private static void write(JsonGenerator out, JobDetail detail) throws IOException {
    out.writeStartObject();
    out.writeNumberField("number", detail.number());
    out.writeNumberField("left", detail.left());
    out.writeArrayFieldStart("calls");
    for (JobDetail.Call call : detail.calls()) {
      out.writeStartObject();
      out.writeStringField("name", call.name());
      out.writeStringField("place", call.place());
      out.writeStringField("line", call.line());
      out.writeEndObject();
    }
    out.writeEndArray();
    out.writeEndObject();
  }

  /** How often, and when last: in milliseconds, -1 for never. */
  static void writeTimes(JsonGenerator out, long times, long last) throws IOException {
    out.writeNumberField("times", times);
    out.writeNumberField("last", last < 0 ? -1 : last / MILLISECOND);
  }

  static void writeTexts(JsonGenerator out, String name, List<String> texts) throws IOException {
    out.writeArrayFieldStart(name);
    for (String text : texts) {
      out.writeString(text);
    }
    out.writeEndArray();
  }

  static void write(JsonGenerator out, String name, List<Long> numbers) throws IOException {
    out.writeArrayFieldStart(name);
    for (long number : numbers) {
      out.writeNumber(number);
    }
    out.writeEndArray();
  }

  static String object(String type, Content content) {
    StringWriter text = new StringWriter();
    try (JsonGenerator out = JSON.createGenerator(text)) {
      out.writeStartObject();
      out.writeStringField("type", type);
      content.write(out);
      out.writeEndObject();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return text.toString();
  }
}
