package org.urbi.ros.one;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;

/** What both sides of a connection of TCPROS say first: names and values. */
final class ConnectionHeader {
  static final String CALLER = "callerid";
  static final String TOPIC = "topic";
  static final String SERVICE = "service";
  static final String TYPE = "type";
  static final String MD5 = "md5sum";
  static final String DEFINITION = "message_definition";
  static final String LATCHING = "latching";
  static final String PERSISTENT = "persistent";
  static final String NO_DELAY = "tcp_nodelay";
  static final String PROBE = "probe";
  static final String ERROR = "error";

  /** In bytes, without its length. */
  static final int MAX_SIZE = 1 << 20;

  private ConnectionHeader() {}

  static byte[] write(Map<String, String> fields) {
    int size = 0;
    for (Map.Entry<String, String> field : fields.entrySet()) {
      size += Integer.BYTES + bytes(field).length;
    }
    ByteBuffer out = ByteBuffer.allocate(Integer.BYTES + size).order(ByteOrder.LITTLE_ENDIAN);
    out.putInt(size);
    for (Map.Entry<String, String> field : fields.entrySet()) {
      byte[] bytes = bytes(field);
      out.putInt(bytes.length).put(bytes);
    }
    return out.array();
  }

  private static byte[] bytes(Map.Entry<String, String> field) {
    return (field.getKey() + "=" + field.getValue()).getBytes(StandardCharsets.UTF_8);
  }

  /** The fields in what comes behind the length. */
  static Map<String, String> read(ByteBuffer in) throws IOException {
    Map<String, String> fields = new LinkedHashMap<>();
    while (in.hasRemaining()) {
      int length = in.remaining() < Integer.BYTES ? -1 : in.getInt();
      if (length < 0 || length > in.remaining()) {
        throw new IOException("no TCPROS: a field of the header is cut off");
      }
      String field = new String(in.array(), in.position(), length, StandardCharsets.UTF_8);
      in.position(in.position() + length);
      int equals = field.indexOf('=');
      if (equals <= 0) {
        throw new IOException("no TCPROS: a field of the header without a name");
      }
      fields.put(field.substring(0, equals), field.substring(equals + 1));
    }
    return fields;
  }
}
