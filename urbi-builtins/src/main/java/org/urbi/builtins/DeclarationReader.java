package org.urbi.builtins;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import javax.annotation.processing.ProcessingEnvironment;
import javax.lang.model.element.Element;
import javax.lang.model.element.ExecutableElement;
import javax.lang.model.element.Modifier;
import javax.lang.model.element.TypeElement;
import javax.lang.model.element.VariableElement;
import javax.lang.model.type.ArrayType;
import javax.lang.model.type.DeclaredType;
import javax.lang.model.type.TypeKind;
import javax.lang.model.type.TypeMirror;
import javax.lang.model.util.ElementFilter;
import javax.tools.Diagnostic;
import org.jspecify.annotations.Nullable;

/** Reads one class of builtins and refuses what cannot be called. */
final class DeclarationReader {
  private static final Map<String, Declaration.Kind> BOXES =
      Map.of(
          "java.lang.Double", Declaration.Kind.DOUBLE,
          "java.lang.Integer", Declaration.Kind.INT,
          "java.lang.Long", Declaration.Kind.LONG,
          "java.lang.Boolean", Declaration.Kind.BOOLEAN);

  private final ProcessingEnvironment environment;

  /** Where each slot is declared, by {@code type.slot}, and each type; shared by all classes. */
  private final Map<String, Element> declared;

  private final ReferenceTexts texts;

  DeclarationReader(
      ProcessingEnvironment environment, Map<String, Element> declared, ReferenceTexts texts) {
    this.environment = environment;
    this.declared = declared;
    this.texts = texts;
  }

  private void error(Element at, String message) {
    environment.getMessager().printMessage(Diagnostic.Kind.ERROR, message, at);
  }

  /** The declaration; null after an error of the class itself. */
  @Nullable Declaration read(TypeElement type) {
    UrbiType main = type.getAnnotation(UrbiType.class);
    UrbiTypePart part = type.getAnnotation(UrbiTypePart.class);
    if (main != null && part != null) {
      error(type, "a class is either @UrbiType or @UrbiTypePart");
      return null;
    }
    if (!type.getModifiers().contains(Modifier.FINAL)) {
      error(type, "a class of builtins must be final");
    }
    String name = main != null ? main.value() : part.value();
    if (name.isBlank()) {
      error(type, "the type has no name");
    }
    if (main != null) {
      checkDoc(type, main.doc());
      checkUnique(type, "type " + name, "the type " + name);
    }
    Declaration declaration =
        new Declaration(
            environment.getElementUtils().getPackageOf(type).getQualifiedName().toString(),
            type.getSimpleName().toString(),
            name,
            main == null ? null : List.of(main.protos()),
            main == null ? "" : main.doc(),
            prototype(type),
            services(type));
    for (ExecutableElement method : ElementFilter.methodsIn(type.getEnclosedElements())) {
      if (method.getAnnotation(Builtin.class) != null) {
        readMethod(declaration, method);
      }
    }
    return declaration;
  }

  private Declaration.Prototype prototype(TypeElement type) {
    return ElementFilter.methodsIn(type.getEnclosedElements()).stream()
        .filter(m ->
            m.getSimpleName().contentEquals("newPrototype")
                && m.getParameters().size() == 1
                && isNamed(m.getParameters().getFirst().asType(), KernelClassNames.WORLD))
        .findFirst()
        .map(m -> isStatic(m) ? Declaration.Prototype.BY_CLASS : Declaration.Prototype.BY_INSTANCE)
        .orElse(Declaration.Prototype.PLAIN_OBJECT);
  }

  /** The parameters of the only constructor of the class; empty if no builtin needs an instance. */
  private List<Declaration.Service> services(TypeElement type) {
    boolean made =
        ElementFilter.methodsIn(type.getEnclosedElements()).stream()
            .anyMatch(m -> m.getAnnotation(Builtin.class) != null && !isStatic(m));
    List<ExecutableElement> constructors = ElementFilter.constructorsIn(type.getEnclosedElements());
    if (!made || constructors.size() != 1) {
      return List.of();
    }
    return constructors.getFirst().getParameters().stream()
        .map(p -> environment.getTypeUtils().erasure(p.asType()).toString())
        .map(Declaration.Service::new)
        .toList();
  }

  private static boolean isStatic(ExecutableElement method) {
    return method.getModifiers().contains(Modifier.STATIC);
  }

  private void checkDoc(Element at, String doc) {
    if (doc.isBlank()) {
      error(at, "the doc is empty");
    } else if (doc.indexOf('\n') >= 0) {
      error(at, "the doc is not one line");
    }
  }

  private void checkUnique(Element at, String key, String what) {
    if (declared.putIfAbsent(key, at) != null) {
      error(at, what + " is declared twice");
    }
  }

  private void readMethod(Declaration type, ExecutableElement method) {
    Builtin builtin = method.getAnnotation(Builtin.class);
    checkDoc(method, builtin.doc());
    if (method.getModifiers().contains(Modifier.PRIVATE)) {
      error(method, "a builtin must not be private");
      return;
    }
    if (!isStatic(method) && type.services.isEmpty()) {
      error(method, "a builtin must be static, or its class have one constructor with parameters");
      return;
    }
    List<String> names =
        builtin.value().length == 0
            ? List.of(method.getSimpleName().toString())
            : List.of(builtin.value());
    for (String name : names) {
      String slot = type.type + "." + name;
      checkUnique(method, slot + (builtin.setter() ? "=" : ""), "the slot " + slot);
      String missing = texts.missing(type.type, name);
      if (missing != null) {
        error(method, missing);
      }
    }
    List<? extends VariableElement> parameters = method.getParameters();
    int next = 0;
    boolean frame =
        next < parameters.size() && isNamed(parameters.get(next).asType(), KernelClassNames.FRAME);
    next += frame ? 1 : 0;
    boolean site =
        next < parameters.size()
            && isNamed(parameters.get(next).asType(), KernelClassNames.CALL_SITE);
    next += site ? 1 : 0;
    Declaration.Parameter self =
        next < parameters.size() ? readParameter(method, parameters.get(next), false) : null;
    if (self == null
        || self.optional()
        || self.kind() != Declaration.Kind.OBJECT && self.kind() != Declaration.Kind.SUBCLASS) {
      error(method, "the target is missing: an UrbiObject, or a subclass of it");
      return;
    }
    List<Declaration.Parameter> arguments = readArguments(method, next + 1);
    if (builtin.lazy() && !parameters.subList(next + 1, parameters.size()).isEmpty()) {
      error(method, "a lazy builtin finds its arguments in the call site");
    }
    if (builtin.setter() && arguments.size() != 1) {
      error(method, "a setter has one argument");
    }
    Declaration.Result result = result(method);
    type.methods.add(
        new Declaration.Method(
            method.getSimpleName().toString(),
            names,
            builtin.doc(),
            builtin.lazy(),
            builtin.min(),
            builtin.max(),
            builtin.setter(),
            need(method, builtin),
            isStatic(method),
            frame,
            site,
            self,
            arguments,
            result,
            resultType(method, result)));
  }

  /** The permission of a method: its own, or that of its class. */
  private static Permission need(ExecutableElement method, Builtin builtin) {
    if (builtin.needs() != Permission.AS_TYPE) {
      return builtin.needs();
    }
    Element owner = requireNonNull(method.getEnclosingElement(), "a method is in a class");
    UrbiType type = owner.getAnnotation(UrbiType.class);
    Permission need = type == null ? owner.getAnnotation(UrbiTypePart.class).needs() : type.needs();
    return need == Permission.AS_TYPE ? Permission.OWNER : need;
  }

  private List<Declaration.Parameter> readArguments(ExecutableElement method, int from) {
    List<? extends VariableElement> parameters = method.getParameters();
    List<Declaration.Parameter> arguments = new ArrayList<>();
    boolean optional = false;
    for (int i = from; i < parameters.size(); i++) {
      boolean last = i == parameters.size() - 1;
      Declaration.Parameter p =
          readParameter(method, parameters.get(i), last && method.isVarArgs());
      if (p == null) {
        continue;
      }
      if (optional && !p.optional() && p.kind() != Declaration.Kind.REST) {
        error(parameters.get(i), "only the last arguments can be optional");
      }
      optional |= p.optional();
      arguments.add(p);
    }
    return arguments;
  }

  private Declaration.@Nullable Parameter readParameter(
      ExecutableElement method, VariableElement parameter, boolean variadic) {
    TypeMirror type = parameter.asType();
    boolean optional = parameter.getAnnotation(Optional.class) != null;
    Declaration.Kind kind = variadic ? restKind(type) : kind(type, optional);
    if (kind == null) {
      error(parameter, "the kind of this parameter is not known: " + type);
      return null;
    }
    if (variadic && optional) {
      error(parameter, "a variadic parameter is optional by itself");
    }
    String javaType = environment.getTypeUtils().erasure(type).toString();
    return new Declaration.Parameter(
        parameter.getSimpleName().toString(), kind, javaType, optional);
  }

  private Declaration.@Nullable Kind restKind(TypeMirror type) {
    return type.getKind() == TypeKind.ARRAY
            && isNamed(((ArrayType) type).getComponentType(), KernelClassNames.OBJECT)
        ? Declaration.Kind.REST
        : null;
  }

  private Declaration.@Nullable Kind kind(TypeMirror type, boolean optional) {
    Declaration.Kind primitive =
        switch (type.getKind()) {
          case DOUBLE -> Declaration.Kind.DOUBLE;
          case INT -> Declaration.Kind.INT;
          case LONG -> Declaration.Kind.LONG;
          case BOOLEAN -> Declaration.Kind.BOOLEAN;
          default -> null;
        };
    if (primitive != null) {
      // Absent arguments are null, which primitives cannot be.
      return optional ? null : primitive;
    }
    if (type.getKind() != TypeKind.DECLARED) {
      return null;
    }
    String name = qualifiedName(type);
    if (name.equals("java.lang.String")) {
      return Declaration.Kind.STRING;
    }
    if (BOXES.containsKey(name)) {
      return optional ? BOXES.get(name) : null;
    }
    if (name.equals(KernelClassNames.OBJECT)) {
      return Declaration.Kind.OBJECT;
    }
    return isObject(type) ? Declaration.Kind.SUBCLASS : null;
  }

  private Declaration.Result result(ExecutableElement method) {
    TypeMirror type = method.getReturnType();
    switch (type.getKind()) {
      case VOID:
        return Declaration.Result.VOID;
      case DOUBLE, INT, LONG:
        return Declaration.Result.NUMBER;
      case BOOLEAN:
        return Declaration.Result.BOOLEAN;
      case DECLARED:
        if (qualifiedName(type).equals("java.lang.String")) {
          return Declaration.Result.STRING;
        }
        if (isObject(type)) {
          return Declaration.Result.OBJECT;
        }
        if (isCollectionOfObjects(type)) {
          return Declaration.Result.LIST;
        }
        break;
      default:
        break;
    }
    error(method, "the kind of this result is not known: " + type);
    return Declaration.Result.VOID;
  }

  /** The type of the result in urbiscript; empty when it may be any. */
  private String resultType(ExecutableElement method, Declaration.Result result) {
    if (result != Declaration.Result.OBJECT
        || isNamed(method.getReturnType(), KernelClassNames.OBJECT)) {
      return result.type;
    }
    return Declaration.typeName(qualifiedName(method.getReturnType()));
  }

  private boolean isObject(TypeMirror type) {
    TypeElement object = environment.getElementUtils().getTypeElement(KernelClassNames.OBJECT);
    return object != null && environment.getTypeUtils().isSubtype(type, object.asType());
  }

  private boolean isCollectionOfObjects(TypeMirror type) {
    TypeElement collection = environment.getElementUtils().getTypeElement("java.util.Collection");
    List<? extends TypeMirror> elements = ((DeclaredType) type).getTypeArguments();
    return environment
            .getTypeUtils()
            .isAssignable(type, environment.getTypeUtils().getDeclaredType(collection))
        && elements.size() == 1
        && isObject(elements.getFirst());
  }

  private static boolean isNamed(TypeMirror type, String name) {
    return type.getKind() == TypeKind.DECLARED && qualifiedName(type).equals(name);
  }

  private static String qualifiedName(TypeMirror type) {
    return ((TypeElement) ((DeclaredType) type).asElement()).getQualifiedName().toString();
  }
}
