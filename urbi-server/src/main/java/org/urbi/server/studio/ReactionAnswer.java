package org.urbi.server.studio;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import org.urbi.kernel.observe.EventRow;
import org.urbi.kernel.observe.ReactionRow;
import org.urbi.kernel.observe.ReactionView;

/** What a browser is told of reactions and events. */
final class ReactionAnswer {
  private ReactionAnswer() {}

  static void write(JsonGenerator out, ReactionView view) throws IOException {
    out.writeStartObject();
    out.writeBooleanField("anew", view.anew());
    out.writeNumberField("total", view.total());
    out.writeArrayFieldStart("rows");
    for (ReactionRow row : view.reactions()) {
      write(out, row);
    }
    out.writeEndArray();
    Answer.write(out, "gone", view.gone());
    out.writeNumberField("eventTotal", view.eventTotal());
    out.writeArrayFieldStart("events");
    for (EventRow row : view.events()) {
      write(out, row);
    }
    out.writeEndArray();
    Answer.write(out, "eventsGone", view.eventsGone());
    out.writeEndObject();
  }

  private static void write(JsonGenerator out, ReactionRow row) throws IOException {
    out.writeStartObject();
    out.writeNumberField("number", row.number());
    out.writeStringField("kind", row.kind());
    out.writeStringField("lobby", row.lobby());
    out.writeStringField("place", row.place());
    out.writeStringField("code", row.code());
    out.writeBooleanField("frozen", row.frozen());
    Answer.write(out, "tags", row.tags());
    out.writeNumberField("event", row.event());
    Answer.writeTexts(out, "read", row.read());
    Answer.writeTimes(out, row.times(), row.last());
    out.writeEndObject();
  }

  private static void write(JsonGenerator out, EventRow row) throws IOException {
    out.writeStartObject();
    out.writeNumberField("number", row.number());
    out.writeStringField("name", row.name());
    out.writeNumberField("listeners", row.listeners());
    Answer.writeTimes(out, row.times(), row.last());
    out.writeEndObject();
  }
}
