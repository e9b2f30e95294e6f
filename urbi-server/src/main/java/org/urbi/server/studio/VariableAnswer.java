package org.urbi.server.studio;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.urbi.kernel.observe.Media;
import org.urbi.kernel.observe.ObjectView;
import org.urbi.kernel.observe.Sample;
import org.urbi.kernel.observe.SlotRow;
import org.urbi.kernel.observe.VariableView;

/** What a browser is told of variables. */
final class VariableAnswer {
  private VariableAnswer() {}

  static void write(JsonGenerator out, VariableView view) throws IOException {
    out.writeStartObject();
    Answer.writeTexts(out, "roots", view.roots());
    out.writeArrayFieldStart("objects");
    for (ObjectView object : view.objects()) {
      write(out, object);
    }
    out.writeEndArray();
    out.writeEndObject();
  }

  private static void write(JsonGenerator out, ObjectView object) throws IOException {
    out.writeStartObject();
    out.writeStringField("way", object.way());
    out.writeBooleanField("anew", object.anew());
    out.writeBooleanField("found", object.found());
    out.writeStringField("type", object.type());
    out.writeNumberField("total", object.total());
    Answer.writeTexts(out, "protos", object.protos());
    out.writeArrayFieldStart("slots");
    for (SlotRow slot : object.slots()) {
      write(out, slot);
    }
    out.writeEndArray();
    Answer.writeTexts(out, "gone", object.gone());
    out.writeEndObject();
  }

  private static void write(JsonGenerator out, SlotRow slot) throws IOException {
    out.writeStartObject();
    out.writeStringField("name", slot.name());
    out.writeStringField("type", slot.type());
    out.writeStringField("value", slot.value());
    out.writeBooleanField("opens", slot.opens());
    writeNumber(out, "number", slot.number());
    writeNumber(out, "least", slot.least());
    writeNumber(out, "most", slot.most());
    out.writeBooleanField("constant", slot.constant());
    out.writeBooleanField("variable", slot.variable());
    out.writeStringField("owner", slot.owner());
    Answer.writeTexts(out, "readers", slot.readers());
    out.writeStringField("media", slot.media());
    Answer.writeTimes(out, slot.times(), slot.last());
    out.writeEndObject();
  }

  private static void writeNumber(JsonGenerator out, String name, double number)
      throws IOException {
    out.writeFieldName(name);
    writeNumber(out, number);
  }

  /** What JSON does not know as a number is null. */
  private static void writeNumber(JsonGenerator out, double number) throws IOException {
    if (Double.isFinite(number)) {
      out.writeNumber(number);
    } else {
      out.writeNull();
    }
  }

  /** The numbers that are plotted, by now. */
  static String sample(long id, Sample sample) {
    return Answer.object(
        "sample",
        out -> {
          out.writeNumberField("id", id);
          out.writeNumberField("time", sample.time() / Answer.MILLISECOND);
          out.writeArrayFieldStart("values");
          for (double value : sample.values()) {
            writeNumber(out, value);
          }
          out.writeEndArray();
        });
  }

  /** An image or a sound, or that there is none. */
  static String shown(long id, Optional<Media> media) {
    return media
        .map(shown ->
            Answer.done(
                id,
                out -> {
                  out.writeStringField("keywords", shown.keywords());
                  out.writeBinaryField(
                      "bytes", shown.bytes().getBytes(StandardCharsets.ISO_8859_1));
                }))
        .orElseGet(() -> Answer.done(id, "no image or sound any more, or more than 4 MiB of it"));
  }
}
