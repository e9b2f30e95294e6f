package org.urbi.ros.one;

import java.util.Base64;
import java.util.List;
import java.util.Map;

/** Writes XML-RPC, without any space between tags: not everybody's reader likes it. */
final class XmlRpcWriter {
  private static final String HEAD = "<?xml version=\"1.0\"?>";

  private final StringBuilder out = new StringBuilder(HEAD);

  private XmlRpcWriter() {}

  /** A call. */
  static String call(String method, List<?> arguments) {
    XmlRpcWriter writer = new XmlRpcWriter();
    writer.out.append("<methodCall><methodName>");
    writer.text(method);
    writer.out.append("</methodName>");
    writer.parameters(arguments);
    return writer.out.append("</methodCall>").toString();
  }

  /** An answer. */
  static String response(Object value) {
    XmlRpcWriter writer = new XmlRpcWriter();
    writer.out.append("<methodResponse>");
    writer.parameters(List.of(value));
    return writer.out.append("</methodResponse>").toString();
  }

  /** A fault. */
  static String fault(String reason) {
    XmlRpcWriter writer = new XmlRpcWriter();
    writer.out.append("<methodResponse><fault>");
    writer.value(Map.of("faultCode", 1, "faultString", reason));
    return writer.out.append("</fault></methodResponse>").toString();
  }

  private void parameters(List<?> values) {
    out.append("<params>");
    for (Object value : values) {
      out.append("<param>");
      value(value);
      out.append("</param>");
    }
    out.append("</params>");
  }

  private void value(Object value) {
    out.append("<value>");
    switch (value) {
      case Integer number -> out.append("<int>").append((int) number).append("</int>");
      case Double number -> out.append("<double>").append((double) number).append("</double>");
      case Boolean truth -> out.append("<boolean>").append(truth ? 1 : 0).append("</boolean>");
      case byte[] bytes ->
          out.append("<base64>")
              .append(Base64.getEncoder().encodeToString(bytes))
              .append("</base64>");
      case List<?> list -> {
        out.append("<array><data>");
        list.forEach(this::value);
        out.append("</data></array>");
      }
      case Map<?, ?> members -> {
        out.append("<struct>");
        members.forEach((name, member) -> {
          out.append("<member><name>");
          text(String.valueOf(name));
          out.append("</name>");
          value(member);
          out.append("</member>");
        });
        out.append("</struct>");
      }
      default -> {
        out.append("<string>");
        text(String.valueOf(value));
        out.append("</string>");
      }
    }
    out.append("</value>");
  }

  private void text(String text) {
    text.codePoints()
        .forEach(c -> {
          switch (c) {
            case '&' -> out.append("&amp;");
            case '<' -> out.append("&lt;");
            case '>' -> out.append("&gt;");
            case '\r' -> out.append("&#13;");
            default -> {
              // XML has no way to write other control characters, nor half characters.
              boolean writable =
                  c >= ' ' && (c < 0xD800 || c > 0xDFFF) && c != 0xFFFE && c != 0xFFFF;
              out.appendCodePoint(writable || c == '\n' || c == '\t' ? c : '?');
            }
          }
        });
  }
}
