package org.urbi.server.studio;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadConstraints;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.observe.Steering;

/** What a browser asks for. */
sealed interface Request {
  /** How many bytes a request may have: a text that is run, all of it written as escapes. */
  int LONGEST = 1 << 20;

  /** How many characters may be run, or checked, at once. */
  int LONGEST_CODE = 1 << 17;

  /** Which job is selected, and whose turns are shown, from now on. */
  record Interest(long selected, List<Long> traced) implements Request {}

  /**
   * The reactions and events are shown from now on, or no longer.
   *
   * @param filter what those that are shown contain; null for none at all
   */
  record Reactions(@Nullable String filter) implements Request {}

  /**
   * The slots of objects are shown from now on, or no longer.
   *
   * @param objects the ways to them; null for none at all
   */
  record Variables(@Nullable List<String> objects) implements Request {}

  /**
   * Numbers are plotted from now on.
   *
   * @param id by which the browser knows the samples
   * @param ways to the slots; none to end it
   */
  record Plot(long id, List<String> ways) implements Request {}

  /**
   * A slot is to be assigned.
   *
   * @param id by which the browser knows the answer
   * @param value an expression of urbiscript
   */
  record Assign(long id, String way, String value) implements Request {}

  /**
   * An image or a sound is to be sent.
   *
   * @param id by which the browser knows the answer
   */
  record Show(long id, String way) implements Request {}

  /**
   * An event is to be emitted.
   *
   * @param id by which the browser knows the answer
   * @param payload expressions of urbiscript, separated by commas
   */
  record Emit(long id, long event, String payload) implements Request {}

  /**
   * A job or a tag is to be controlled.
   *
   * @param id by which the browser knows the answer
   */
  record Steer(long id, Steering.Action action, boolean tag, long target) implements Request {}

  /**
   * The address of a file to which variables were recorded is wanted.
   *
   * @param id by which the browser knows the answer
   * @param recording its number
   */
  record Download(long id, int recording) implements Request {}

  /** What people want of code that they have written. */
  sealed interface OfCode extends Request {}

  /**
   * A text is to be run, under a tag of its own.
   *
   * @param id by which the browser knows the answer, which comes when it has ended
   * @param file the name by which errors call the text
   */
  record Run(long id, String file, String code) implements OfCode {}

  /**
   * A text that is run is to be ended.
   *
   * @param id by which the browser knows the answer
   * @param run the number that the text was given when it began
   */
  record Stop(long id, int run) implements OfCode {}

  /**
   * The syntax errors of a text are wanted.
   *
   * @param id by which the browser knows the answer
   */
  record Check(long id, String code) implements OfCode {}

  /**
   * The completions of a text are wanted.
   *
   * @param id by which the browser knows the answer
   */
  record Complete(long id, String text) implements OfCode {}

  /** What people want of files. */
  sealed interface OfFiles extends Request {
    /** By which the browser knows the answer. */
    long id();
  }

  /** The names of the files are wanted. */
  record Files(long id) implements OfFiles {}

  /** The content of a file is wanted. */
  record Open(long id, String name) implements OfFiles {}

  /**
   * A file is to be written.
   *
   * @param version of which the text has been made; empty if it is to be a new file
   */
  record Save(long id, String name, String text, String version) implements OfFiles {}

  /**
   * Reads a request.
   *
   * @throws BadRequest if it is none
   */
  static Request read(String text) throws BadRequest {
    Fields fields = new Fields(text);
    return switch (fields.text("type")) {
      case "interest" -> new Interest(fields.number("selected"), fields.numbers("traced"));
      case "reactions" -> new Reactions(fields.textOrNull("filter"));
      case "emit" -> new Emit(fields.number("id"), fields.number("event"), fields.text("payload"));
      case "variables" -> new Variables(fields.textsOrNull("objects"));
      case "plot" -> {
        List<String> ways = fields.textsOrNull("ways");
        yield new Plot(fields.number("id"), ways == null ? List.of() : ways);
      }
      case "assign" -> new Assign(fields.number("id"), fields.text("way"), fields.text("value"));
      case "show" -> new Show(fields.number("id"), fields.text("way"));
      case "download" -> new Download(fields.number("id"), fields.integer("recording"));
      case "run" -> new Run(fields.number("id"), fields.text("file"), fields.code("code"));
      case "stop" -> new Stop(fields.number("id"), fields.integer("run"));
      case "check" -> new Check(fields.number("id"), fields.code("code"));
      case "files" -> new Files(fields.number("id"));
      case "open" -> new Open(fields.number("id"), fields.text("name"));
      case "save" ->
          new Save(
              fields.number("id"),
              fields.text("name"),
              fields.code("text"),
              fields.text("version"));
      case "complete" -> new Complete(fields.number("id"), fields.text("text"));
      case "steer" -> {
        Steering.Action action = Steering.Action.of(fields.text("action"));
        if (action == null) {
          throw fields.refusal("action: stop, freeze, unfreeze, block or unblock expected");
        }
        String kind = fields.text("kind");
        if (!kind.equals("job") && !kind.equals("tag")) {
          throw fields.refusal("kind: job or tag expected");
        }
        yield new Steer(fields.number("id"), action, kind.equals("tag"), fields.number("target"));
      }
      default ->
          throw fields.refusal(
              "type: interest, steer, reactions, emit, variables, plot, assign, show, download,"
                  + " run, stop, check, complete, files, open or save expected");
    };
  }

  /** The fields of a JSON object. */
  final class Fields {
    private static final int DEEPEST = 4;
    private static final int LONGEST_NUMBER = 20;

    /** How many characters a text may have that is no code. */
    private static final int LONGEST_TEXT = 1 << 13;

    private static final JsonFactory JSON =
        JsonFactory.builder()
            .streamReadConstraints(
                StreamReadConstraints.builder()
                    .maxNestingDepth(DEEPEST)
                    .maxNumberLength(LONGEST_NUMBER)
                    .maxStringLength(LONGEST)
                    .build())
            .build();

    private final Map<String, Object> values = new HashMap<>();

    Fields(String text) throws BadRequest {
      try (JsonParser parser = JSON.createParser(text)) {
        if (parser.nextToken() != JsonToken.START_OBJECT) {
          throw new BadRequest("a JSON object expected");
        }
        while (parser.nextToken() != JsonToken.END_OBJECT) {
          String name = parser.currentName();
          Object value = value(parser);
          if (value != null) {
            values.put(name, value);
          }
        }
        if (parser.nextToken() != null) {
          throw new BadRequest("one JSON object expected, not more");
        }
      } catch (IOException e) {
        throw new BadRequest(
            "no JSON: " + String.valueOf(e.getMessage()).lines().findFirst().orElse(""));
      }
    }

    private static @Nullable Object value(JsonParser parser) throws IOException {
      return switch (parser.nextToken()) {
        case VALUE_STRING -> parser.getText();
        case VALUE_NUMBER_INT -> parser.getLongValue();
        case START_ARRAY -> {
          List<Object> elements = new ArrayList<>();
          for (JsonToken token = parser.nextToken();
              token != JsonToken.END_ARRAY;
              token = parser.nextToken()) {
            elements.add(
                switch (token) {
                  case VALUE_NUMBER_INT -> parser.getLongValue();
                  case VALUE_STRING -> parser.getText();
                  default -> token;
                });
          }
          yield elements;
        }
        case START_OBJECT -> {
          parser.skipChildren();
          yield null;
        }
        default -> null;
      };
    }

    /** Whoever waits for an answer is given one; the number of a plot is not that of a question. */
    BadRequest refusal(String reason) {
      boolean plot = "plot".equals(values.get("type"));
      return new BadRequest(reason, !plot && values.get("id") instanceof Long id ? id : null);
    }

    String text(String name) throws BadRequest {
      return text(name, LONGEST_TEXT);
    }

    String code(String name) throws BadRequest {
      return text(name, LONGEST_CODE);
    }

    private String text(String name, int longest) throws BadRequest {
      if (!(values.get(name) instanceof String text)) {
        throw refusal(name + ": a string expected");
      }
      if (text.length() > longest) {
        throw refusal(name + ": at most " + longest + " characters, not " + text.length());
      }
      return text;
    }

    /** The text; null if there is no such field. */
    @Nullable String textOrNull(String name) throws BadRequest {
      return values.containsKey(name) ? text(name) : null;
    }

    long number(String name) throws BadRequest {
      if (values.get(name) instanceof Long number) {
        return number;
      }
      throw refusal(name + ": a whole number expected");
    }

    int integer(String name) throws BadRequest {
      long number = number(name);
      if (number != (int) number) {
        throw refusal(name + ": no such number: " + number);
      }
      return (int) number;
    }

    /** The texts of a list; null if there is no such field. */
    @Nullable List<String> textsOrNull(String name) throws BadRequest {
      if (!values.containsKey(name)) {
        return null;
      }
      List<String> texts = new ArrayList<>();
      if (values.get(name) instanceof List<?> elements) {
        for (Object element : elements) {
          if (!(element instanceof String text)) {
            throw refusal(name + ": strings expected");
          }
          texts.add(text);
        }
        return texts;
      }
      throw refusal(name + ": a list of strings expected");
    }

    List<Long> numbers(String name) throws BadRequest {
      List<Long> numbers = new ArrayList<>();
      if (values.get(name) instanceof List<?> elements) {
        for (Object element : elements) {
          if (!(element instanceof Long number)) {
            throw refusal(name + ": whole numbers expected");
          }
          numbers.add(number);
        }
        return numbers;
      }
      throw refusal(name + ": a list of whole numbers expected");
    }
  }
}
