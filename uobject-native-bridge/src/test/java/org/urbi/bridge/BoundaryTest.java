package org.urbi.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import urbi.wire.ValueEncoder;

/** Both sides of the boundary agree: what the headers say is what the Java classes say. */
class BoundaryTest {
  private static final Path HEADERS = Path.of("src/main/native/include/urbi/detail");
  private static final Pattern CONSTANT = Pattern.compile("(\\w+)\\s*(?:=\\s*(\\d+))?\\s*(,|$)");
  private static final Pattern FIELD = Pattern.compile("(?:int64_t|uint8_t\\s*\\*)\\s*(\\w+)\\s*;");

  private static String header(String name) throws IOException {
    return Files.readString(HEADERS.resolve(name))
        .replaceAll("(?s)/\\*.*?\\*/", "")
        .replaceAll("//[^\n]*", "");
  }

  private static String block(String text, String begin) {
    int start = text.indexOf('{', text.indexOf(begin));
    assertTrue(text.contains(begin) && start >= 0, begin);
    return text.substring(start + 1, text.indexOf('}', start)).strip();
  }

  /** Constants of an enumeration, as C numbers them. */
  private static Map<String, Long> constants(String text, String begin, String prefix) {
    Map<String, Long> constants = new LinkedHashMap<>();
    Matcher each = CONSTANT.matcher(block(text, begin));
    long next = 0;
    while (each.find()) {
      long value = each.group(2) == null ? next : Long.parseLong(each.group(2));
      assertTrue(each.group(1).startsWith(prefix), each.group(1));
      constants.put(each.group(1).substring(prefix.length()), value);
      next = value + 1;
    }
    return constants;
  }

  /** The static constants of a class whose names start so. */
  private static Map<String, Long> constants(Class<?> type, String prefix, Class<?> kind)
      throws IllegalAccessException {
    Map<String, Long> constants = new LinkedHashMap<>();
    for (Field field : type.getDeclaredFields()) {
      if (Modifier.isStatic(field.getModifiers())
          && field.getType() == kind
          && field.getName().startsWith(prefix)) {
        field.setAccessible(true);
        constants.put(
            field.getName().substring(prefix.length()), ((Number) field.get(null)).longValue());
      }
    }
    return constants;
  }

  @Test
  void operations() throws Exception {
    Map<String, Long> asked = constants(header("boundary.h"), "enum urbi_request", "URBI_");
    assertTrue(asked.size() > 30, asked::toString);
    assertEquals(asked, constants(RequestHandler.class, "", int.class));
  }

  @Test
  void layoutOfAnExchange() throws Exception {
    Map<String, Long> offsets = new LinkedHashMap<>();
    Matcher field = FIELD.matcher(block(header("boundary.h"), "struct urbi_exchange"));
    while (field.find()) {
      offsets.put(field.group(1).toUpperCase(Locale.ROOT), (long) Long.BYTES * offsets.size());
    }
    assertEquals(8, offsets.size());
    Map<String, Long> known = constants(Exchange.class, "", int.class);
    assertEquals((long) Long.BYTES * offsets.size(), known.remove("SIZE"));
    assertEquals(offsets, known);
    assertTrue(header("boundary.h").contains("URBI_FAILED INT64_MIN"));
    assertEquals(Long.MIN_VALUE, Exchange.FAILED);
  }

  @Test
  void version() throws Exception {
    Matcher version =
        Pattern.compile("#define\\s+URBI_BOUNDARY_VERSION\\s+(\\d+)").matcher(header("boundary.h"));
    assertTrue(version.find());
    assertEquals(
        Map.of("VERSION", Long.valueOf(version.group(1))),
        constants(NativeModule.class, "BOUNDARY_", long.class));
  }

  @Test
  void valuesOfAllKinds() throws Exception {
    assertEquals(
        Map.of(
            "VOID", (long) ValueEncoder.VOID,
            "NUMBER", (long) ValueEncoder.DOUBLE,
            "STRING", (long) ValueEncoder.STRING,
            "LIST", (long) ValueEncoder.LIST,
            "DICTIONARY", (long) ValueEncoder.DICTIONARY,
            "BINARY", (long) ValueEncoder.BINARY,
            "SLOTNAME", (long) ValueEncoder.SLOT_NAME,
            "POINTER", (long) ValueWriter.POINTER),
        constants(header("wire.hh"), "enum Mark", "MARK_"));
  }
}
