package org.urbi.ros.one;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.StringReader;
import java.util.ArrayList;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;

/**
 * Reads XML-RPC. Values are {@link Integer}, {@link Double}, {@link Boolean}, {@link String},
 * {@code byte[]}, {@link List} and {@link Map}.
 */
final class XmlRpcReader {
  private static final int MAX_DEPTH = 64;
  private static final XMLInputFactory FACTORY = factory();

  private final XMLStreamReader in;

  private XmlRpcReader(byte[] document) throws XMLStreamException {
    in = FACTORY.createXMLStreamReader(new StringReader(new String(document, UTF_8)));
  }

  private static XMLInputFactory factory() {
    XMLInputFactory factory = XMLInputFactory.newFactory();
    factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
    factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
    factory.setProperty(XMLInputFactory.IS_COALESCING, true);
    return factory;
  }

  /** A call. */
  record Call(String method, List<Object> arguments) {}

  private interface Reading<T> {
    T read(XmlRpcReader reader) throws XMLStreamException, XmlRpcException;
  }

  private static <T> T read(byte[] document, Reading<T> reading) throws XmlRpcException {
    try {
      XmlRpcReader reader = new XmlRpcReader(document);
      try {
        return reading.read(reader);
      } finally {
        reader.in.close();
      }
    } catch (XMLStreamException | IllegalArgumentException e) {
      throw new XmlRpcException("no XML-RPC: " + e.getMessage());
    }
  }

  /** Reads a call. */
  static Call call(byte[] document) throws XmlRpcException {
    return read(
        document,
        reader -> {
          reader.open("methodCall");
          reader.open("methodName");
          String method = reader.in.getElementText().strip();
          List<Object> arguments = new ArrayList<>();
          if (reader.in.nextTag() == XMLStreamReader.START_ELEMENT) {
            reader.expect("params");
            while (reader.in.nextTag() == XMLStreamReader.START_ELEMENT) {
              arguments.add(reader.parameter());
            }
          }
          return new Call(method, List.copyOf(arguments));
        });
  }

  /** Reads an answer; a fault is thrown. */
  static Object response(byte[] document) throws XmlRpcException {
    return read(
        document,
        reader -> {
          reader.open("methodResponse");
          reader.in.nextTag();
          if (reader.in.getLocalName().equals("fault")) {
            reader.open("value");
            throw new XmlRpcException(String.valueOf(reader.value(0)));
          }
          reader.expect("params");
          reader.in.nextTag();
          return reader.parameter();
        });
  }

  private void open(String name) throws XMLStreamException, XmlRpcException {
    in.nextTag();
    expect(name);
  }

  private void expect(String name) throws XmlRpcException {
    if (!in.isStartElement() || !in.getLocalName().equals(name)) {
      throw new XmlRpcException("no XML-RPC: <" + name + "> expected");
    }
  }

  private Object parameter() throws XMLStreamException, XmlRpcException {
    expect("param");
    open("value");
    Object value = value(0);
    in.nextTag();
    return value;
  }

  /** Reads what is in a value, and its end. */
  private Object value(int depth) throws XMLStreamException, XmlRpcException {
    if (depth > MAX_DEPTH) {
      throw new XmlRpcException("no XML-RPC of ROS: too deep");
    }
    StringBuilder text = new StringBuilder();
    int event = in.next();
    while (event == XMLStreamReader.CHARACTERS
        || event == XMLStreamReader.SPACE
        || event == XMLStreamReader.COMMENT) {
      if (event != XMLStreamReader.COMMENT) {
        text.append(in.getText());
      }
      event = in.next();
    }
    if (event == XMLStreamReader.END_ELEMENT) {
      return text.toString();
    }
    Object value =
        switch (in.getLocalName()) {
          case "array" -> array(depth);
          case "struct" -> struct(depth);
          case "string", "dateTime.iso8601" -> in.getElementText();
          case "int", "i4" -> Integer.valueOf(in.getElementText().strip());
          case "double" -> Double.valueOf(in.getElementText().strip());
          case "boolean" -> in.getElementText().strip().equals("1");
          case "base64" -> Base64.getMimeDecoder().decode(in.getElementText());
          default -> throw new XmlRpcException("no type of XML-RPC: " + in.getLocalName());
        };
    in.nextTag();
    return value;
  }

  private List<Object> array(int depth) throws XMLStreamException, XmlRpcException {
    List<Object> values = new ArrayList<>();
    open("data");
    while (in.nextTag() == XMLStreamReader.START_ELEMENT) {
      expect("value");
      values.add(value(depth + 1));
    }
    in.nextTag();
    return values;
  }

  private Map<String, Object> struct(int depth) throws XMLStreamException, XmlRpcException {
    Map<String, Object> members = new LinkedHashMap<>();
    while (in.nextTag() == XMLStreamReader.START_ELEMENT) {
      expect("member");
      open("name");
      String name = in.getElementText();
      open("value");
      members.put(name, value(depth + 1));
      in.nextTag();
    }
    return members;
  }
}
