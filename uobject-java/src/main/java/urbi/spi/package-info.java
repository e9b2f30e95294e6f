/**
 * What those need who give UObjects a home, a kernel or a process that is connected to one: loading
 * modules, threads, and what to say when a component fails. The interfaces that UObjects call,
 * {@link urbi.UContext} and {@link urbi.USlot}, are in the package of the UObjects.
 */
@NullMarked
package urbi.spi;

import org.jspecify.annotations.NullMarked;
