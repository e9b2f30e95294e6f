package urbi;

import java.io.ByteArrayOutputStream;
import java.util.Map;

/** Writes values as urbiscript literals. */
final class UValueWriter {
  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private final StringBuilder text = new StringBuilder();
  private final boolean toBytes;

  private UValueWriter(boolean toBytes) {
    this.toBytes = toBytes;
  }

  /** For people and for {@link UValue#parse(String)}; one character for each byte of a binary. */
  static String text(UValue value) {
    var writer = new UValueWriter(false);
    writer.write(value);
    return writer.text.toString();
  }

  /** For a server. */
  static byte[] bytes(UValue value) {
    var writer = new UValueWriter(true);
    writer.write(value);
    writer.flush();
    return writer.out.toByteArray();
  }

  /** The shortest text that reads as that number again. */
  static String number(double value) {
    if (Double.isNaN(value)) {
      return "nan";
    }
    if (Double.isInfinite(value)) {
      return value > 0 ? "inf" : "-inf";
    }
    if (value == Math.rint(value) && Math.abs(value) < 1e15) {
      return value == 0 && 1 / value < 0 ? "-0" : Long.toString((long) value);
    }
    String shown = Double.toString(value);
    int exponent = shown.indexOf('E');
    if (exponent < 0) {
      return shown;
    }
    String digits = shown.substring(0, exponent);
    if (digits.endsWith(".0")) {
      digits = digits.substring(0, digits.length() - 2);
    }
    return digits + "e" + shown.substring(exponent + 1);
  }

  private void write(UValue value) {
    switch (value.getType()) {
      case DATA_VOID -> text.append("void");
      case DATA_DOUBLE -> text.append(number(value.doubleValue()));
      case DATA_SLOTNAME -> text.append(value.stringValue());
      case DATA_STRING -> quote(value.stringValue());
      case DATA_BINARY -> binary(value.ubinaryValue());
      case DATA_LIST -> list(value.ulistValue());
      case DATA_DICTIONARY -> dictionary(value.udictionaryValue());
    }
  }

  private void list(UList list) {
    String separator = "[";
    for (UValue element : list) {
      text.append(separator);
      write(element);
      separator = ", ";
    }
    text.append(list.isEmpty() ? "[]" : "]");
  }

  private void dictionary(UDictionary dictionary) {
    String separator = "[";
    for (Map.Entry<String, UValue> entry : dictionary.entrySet()) {
      text.append(separator);
      quote(entry.getKey());
      text.append(" => ");
      write(entry.getValue());
      separator = ", ";
    }
    text.append(dictionary.isEmpty() ? "[ => ]" : "]");
  }

  private void quote(String string) {
    text.append('"');
    for (int i = 0; i < string.length(); i++) {
      char c = string.charAt(i);
      switch (c) {
        case '"', '\\' -> text.append('\\').append(c);
        case '\n' -> text.append("\\n");
        case '\r' -> text.append("\\r");
        case '\t' -> text.append("\\t");
        default -> {
          if (c < ' ' || c == 0x7f) {
            text.append("\\x").append(Character.forDigit(c >> 4, 16));
            text.append(Character.forDigit(c & 15, 16));
          } else {
            text.append(c);
          }
        }
      }
    }
    text.append('"');
  }

  /**
   * {@code BIN size header;data} where a parser of urbiscript takes the header, and a call with the
   * data as a string otherwise.
   */
  private void binary(UBinary binary) {
    String header = binary.getMessage();
    boolean plain = !toBytes || isPlain(header);
    if (plain) {
      text.append("BIN ").append(binary.getSize());
      text.append(header.isEmpty() ? "" : " ").append(header).append(';');
    } else {
      text.append("Binary.new(");
      quote(header);
      text.append(", \"\\B(").append(binary.getSize()).append(")(");
    }
    data(binary.getData());
    if (!plain) {
      text.append(")\")");
    }
  }

  private void data(byte[] data) {
    if (toBytes) {
      flush();
      out.writeBytes(data);
    } else {
      for (byte b : data) {
        text.append((char) (b & 0xff));
      }
    }
  }

  private static boolean isPlain(String header) {
    return header
        .chars()
        .allMatch(
            c -> c == ' ' || c < 128 && Character.isLetterOrDigit(c) || "_.-:=".indexOf(c) >= 0);
  }

  private void flush() {
    out.writeBytes(TextCoding.encode(text.toString()));
    text.setLength(0);
  }
}
