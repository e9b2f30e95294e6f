/** The object model: slots, prototypes, shapes, properties; knows nothing of code. */
package org.urbi.kernel.object;
