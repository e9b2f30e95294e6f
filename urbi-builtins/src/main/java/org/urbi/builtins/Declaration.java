package org.urbi.builtins;

import static java.util.stream.Collectors.joining;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** A class of builtins, read from its annotations and ready to be written as a table. */
final class Declaration {
  /** How an argument is converted from urbiscript to Java. */
  enum Kind {
    OBJECT(null, ""),
    SUBCLASS(null, ""),
    DOUBLE("number", "Float"),
    INT("integer", "Float"),
    LONG("longInteger", "Float"),
    BOOLEAN("truth", "Boolean"),
    STRING("text", "String"),
    REST("rest", "");

    /** The method of {@code Arguments} that unwraps it. */
    final @Nullable String unwrapper;

    /** The type in urbiscript; empty when any will do, or when it depends on the Java class. */
    final String type;

    Kind(@Nullable String unwrapper, String type) {
      this.unwrapper = unwrapper;
      this.type = type;
    }
  }

  /** How the result is converted from Java to urbiscript. */
  enum Result {
    OBJECT(""),
    VOID("void"),
    NUMBER("Float"),
    BOOLEAN("Boolean"),
    STRING("String"),
    LIST("List");

    /** The type in urbiscript; empty when it depends on the Java class. */
    final String type;

    Result(String type) {
      this.type = type;
    }
  }

  /** One parameter; the target and the arguments. */
  record Parameter(String name, Kind kind, String javaType, boolean optional) {
    /** How urbiscript names the type, after the Java class. */
    String typeName() {
      return Declaration.typeName(javaType);
    }

    /** The parameter as the documentation shows it: {@code from: Float}, {@code to?}. */
    String shown() {
      String type = kind == Kind.SUBCLASS ? typeName() : kind.type;
      return name
          + (optional ? "?" : "")
          + (kind == Kind.REST ? "..." : "")
          + (type.isEmpty() ? "" : ": " + type);
    }
  }

  /** How urbiscript names the type of a Java class. */
  static String typeName(String javaType) {
    String simple = javaType.substring(javaType.lastIndexOf('.') + 1);
    return simple.startsWith("Urbi") ? simple.substring(4) : simple;
  }

  /** One method. */
  record Method(
      String javaName,
      List<String> names,
      String doc,
      boolean lazy,
      int lazyMin,
      int lazyMax,
      boolean setter,
      Permission needs,
      boolean isStatic,
      boolean frame,
      boolean site,
      Parameter self,
      List<Parameter> arguments,
      Result result,
      String resultType) {
    int min() {
      if (lazy) {
        return lazyMin;
      }
      return (int) arguments.stream().filter(p -> !p.optional() && p.kind() != Kind.REST).count();
    }

    /** The most arguments; -1 when there may be any number. */
    int max() {
      if (lazy) {
        return lazyMax;
      }
      return arguments.stream().anyMatch(p -> p.kind() == Kind.REST) ? -1 : arguments.size();
    }

    /** The arguments as the documentation shows them: {@code (from: Float, to?: Float)}. */
    String formals() {
      if (lazy) {
        return "(...)";
      }
      return arguments.isEmpty()
          ? ""
          : arguments.stream().map(Parameter::shown).collect(joining(", ", "(", ")"));
    }
  }

  /** A service of the kernel that a class of builtins needs: a parameter of its constructor. */
  record Service(String javaType) {
    /** Its parameter name, the same in all classes. */
    String name() {
      String simple = javaType.substring(javaType.lastIndexOf('.') + 1);
      return Character.toLowerCase(simple.charAt(0)) + simple.substring(1);
    }

    @Override
    public String toString() {
      return javaType + " " + name();
    }
  }

  final String packageName;
  final String className;
  final String type;

  /** The prototypes; null in a part of a type that another class declares. */
  final @Nullable List<String> protos;

  final String doc;

  /** How the prototype is created. */
  enum Prototype {
    PLAIN_OBJECT,
    BY_CLASS,
    BY_INSTANCE
  }

  final Prototype prototype;

  /** The parameters of the constructor; empty when all builtins are static. */
  final List<Service> services;

  final List<Method> methods = new ArrayList<>();

  Declaration(
      String packageName,
      String className,
      String type,
      @Nullable List<String> protos,
      String doc,
      Prototype prototype,
      List<Service> services) {
    this.packageName = packageName;
    this.className = className;
    this.type = type;
    this.protos = protos;
    this.doc = doc;
    this.prototype = prototype;
    this.services = services;
  }

  boolean isPart() {
    return protos == null;
  }

  /** The simple name of the generated class. */
  String tableName() {
    return className + "Table";
  }
}
