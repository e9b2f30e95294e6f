package urbi;

import java.io.ByteArrayOutputStream;
import org.jspecify.annotations.Nullable;

/**
 * Reads urbiscript literals of values, from bytes as a server sends them or from text.
 *
 * <p>In text, a character of the data of a binary stands for a byte, and all others for themselves.
 */
final class UValueReader {
  private static final int DEEPEST = 1000;

  private final byte @Nullable [] bytes;
  private final String text;
  private final int end;
  private int at;
  private int depth;

  UValueReader(byte[] bytes, int from, int end) {
    this.bytes = bytes;
    this.text = "";
    this.at = from;
    this.end = end;
  }

  UValueReader(String text) {
    this.bytes = null;
    this.text = text;
    this.end = text.length();
  }

  /** The one value that there is. */
  UValue whole() {
    UValue value = value();
    skipBlanks();
    if (at < end) {
      throw error("unexpected `" + (char) unit(at) + "'");
    }
    return value;
  }

  /** The next value. */
  UValue value() {
    skipBlanks();
    int c = peek();
    if (c == '"') {
      return new UValue(string());
    }
    if (c == '[') {
      return nested();
    }
    if (c == '(') {
      return nested();
    }
    if (c == '-' || c == '+' || c == '.' || isDigit(c)) {
      return new UValue(number());
    }
    if (isLetter(c)) {
      return named();
    }
    throw error(c < 0 ? "a value is missing" : "unexpected `" + (char) c + "'");
  }

  private UValue nested() {
    if (++depth > DEEPEST) {
      throw error("more than " + DEEPEST + " lists in one another");
    }
    UValue value = peek() == '[' ? brackets() : tuple();
    depth--;
    return value;
  }

  private UValue tuple() {
    at++;
    UList list = new UList();
    while (!accept(')')) {
      list.add(value());
      if (!accept(',')) {
        expect(')');
        break;
      }
    }
    return new UValue(list);
  }

  private UValue brackets() {
    at++;
    if (accept(']')) {
      return new UValue(new UList());
    }
    if (acceptArrow()) {
      expect(']');
      return new UValue(new UDictionary());
    }
    UValue first = value();
    if (acceptArrow()) {
      return dictionary(first);
    }
    UList list = new UList();
    list.add(first);
    while (accept(',')) {
      if (accept(']')) {
        return new UValue(list);
      }
      list.add(value());
    }
    expect(']');
    return new UValue(list);
  }

  private UValue dictionary(UValue first) {
    UDictionary dictionary = new UDictionary();
    dictionary.put(key(first), value());
    while (accept(',')) {
      if (accept(']')) {
        return new UValue(dictionary);
      }
      UValue key = value();
      if (!acceptArrow()) {
        throw error("`=>' is missing");
      }
      dictionary.put(key(key), value());
    }
    expect(']');
    return new UValue(dictionary);
  }

  private static String key(UValue value) {
    return value.getType() == UDataType.DATA_STRING ? value.stringValue() : value.toString();
  }

  /** A word: true, false, void and the like, a binary, or the name of a slot. */
  private UValue named() {
    int start = at;
    while (isLetter(peek()) || isDigit(peek()) || peek() == '.' && isLetter(peekAt(1))) {
      at++;
    }
    String word = slice(start, at);
    switch (word) {
      case "BIN" -> {
        return new UValue(binary());
      }
      case "true" -> {
        return new UValue(true);
      }
      case "false" -> {
        return new UValue(false);
      }
      case "void", "nil" -> {
        return new UValue();
      }
      case "inf" -> {
        return new UValue(Double.POSITIVE_INFINITY);
      }
      case "nan" -> {
        return new UValue(Double.NaN);
      }
      default -> {
        return UValue.slotName(word);
      }
    }
  }

  private UBinary binary() {
    skipBlanks();
    int start = at;
    while (isDigit(peek())) {
      at++;
    }
    int size;
    try {
      size = Integer.parseInt(slice(start, at));
    } catch (NumberFormatException e) {
      throw error("the size of a binary is missing or too large");
    }
    int header = at;
    while (at < end && unit(at) != ';' && unit(at) != '\n') {
      at++;
    }
    if (end - at <= size) {
      throw error("the data of a binary end too early");
    }
    String keywords = slice(header, at).strip();
    at++;
    byte[] data = new byte[size];
    if (bytes != null) {
      System.arraycopy(bytes, at, data, 0, size);
    } else {
      for (int i = 0; i < size; i++) {
        if (text.charAt(at + i) > 0xff) {
          throw error("a character of a binary is no byte");
        }
        data[i] = (byte) text.charAt(at + i);
      }
    }
    at += size;
    return new UBinary(keywords, data);
  }

  private double number() {
    int sign = 1;
    while (peek() == '-' || peek() == '+') {
      sign = unit(at++) == '-' ? -sign : sign;
      skipBlanks();
    }
    int start = at;
    while (isDigit(peek()) || isLetter(peek()) || peek() == '.' || signOfExponent(start)) {
      at++;
    }
    double value = NumberText.parse(slice(start, at));
    if (Double.isNaN(value) && !slice(start, at).equals("nan")) {
      at = start;
      throw error("no number");
    }
    return sign * value;
  }

  private boolean signOfExponent(int start) {
    return (peek() == '-' || peek() == '+')
        && at > start
        && (unit(at - 1) | 0x20) == 'e'
        && isDigit(unit(start))
        && isDigit(peekAt(1));
  }

  /** A string, or several next to one another, which are one. */
  private String string() {
    var content = new ByteArrayOutputStream();
    do {
      at++;
      while (peek() != '"') {
        int c = peek();
        if (c < 0) {
          throw error("the closing quote is missing");
        }
        if (c == '\\') {
          at++;
          escape(content);
        } else {
          character(content);
        }
      }
      at++;
      skipBlanks();
    } while (peek() == '"');
    return TextCoding.decode(content.toByteArray(), 0, content.size());
  }

  private void character(ByteArrayOutputStream content) {
    if (bytes != null || text.charAt(at) < 0x80) {
      content.write(unit(at++));
    } else {
      int point = text.codePointAt(at);
      content.writeBytes(TextCoding.encode(Character.toString(point)));
      at += Character.charCount(point);
    }
  }

  private void escape(ByteArrayOutputStream content) {
    int c = peek();
    at++;
    switch (c) {
      case 'a' -> content.write(7);
      case 'b' -> content.write('\b');
      case 'f' -> content.write('\f');
      case 'n' -> content.write('\n');
      case 'r' -> content.write('\r');
      case 't' -> content.write('\t');
      case 'v' -> content.write(11);
      case '"', '\\', '\'' -> content.write(c);
      case 'x' -> content.write(digits(16, 2, 2));
      case 'B' -> blob(content);
      default -> {
        if (c < '0' || c > '7') {
          throw error("unknown escape");
        }
        at--;
        content.write(digits(8, 1, 3));
      }
    }
  }

  private int digits(int radix, int least, int most) {
    int value = 0;
    int read = 0;
    while (read < most && Character.digit(peek(), radix) >= 0) {
      value = value * radix + Character.digit(unit(at++), radix);
      read++;
    }
    if (read < least || value > 0xff) {
      throw error("wrong number in an escape");
    }
    return value;
  }

  private void blob(ByteArrayOutputStream content) {
    expect('(');
    int start = at;
    while (isDigit(peek())) {
      at++;
    }
    String size = slice(start, at);
    expect(')');
    expect('(');
    int length = size.isEmpty() || size.length() > 9 ? -1 : Integer.parseInt(size);
    if (length < 0 || end - at <= length) {
      throw error("wrong size in an escape");
    }
    for (int i = 0; i < length; i++) {
      content.write(unit(at++));
    }
    if (peek() != ')') {
      throw error("`)' is missing");
    }
    at++;
  }

  private boolean accept(char expected) {
    skipBlanks();
    if (peek() != expected) {
      return false;
    }
    at++;
    return true;
  }

  private boolean acceptArrow() {
    skipBlanks();
    if (peek() != '=' || peekAt(1) != '>') {
      return false;
    }
    at += 2;
    return true;
  }

  private void expect(char expected) {
    if (!accept(expected)) {
      throw error("`" + expected + "' is missing");
    }
  }

  private void skipBlanks() {
    while (at < end && unit(at) <= ' ') {
      at++;
    }
  }

  private int peek() {
    return peekAt(0);
  }

  private int peekAt(int ahead) {
    return at + ahead < end ? unit(at + ahead) : -1;
  }

  private int unit(int index) {
    return bytes != null ? bytes[index] & 0xff : text.charAt(index);
  }

  private String slice(int from, int to) {
    return bytes != null ? TextCoding.decode(bytes, from, to - from) : text.substring(from, to);
  }

  private static boolean isDigit(int c) {
    return '0' <= c && c <= '9';
  }

  private static boolean isLetter(int c) {
    return 'a' <= c && c <= 'z' || 'A' <= c && c <= 'Z' || c == '_';
  }

  private UParseException error(String message) {
    return new UParseException(message, at);
  }
}
