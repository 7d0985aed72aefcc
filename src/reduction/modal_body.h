// A body that is given by its modes.
#pragma once

#include "reduction/modal_data.h"

namespace vibroimpact::reduction {

/// Unit modal masses, whatever the normalisation of the data; with the residual modes that the
/// definition asks for. Throws DefinitionError for data that contradict the definition.
ReducedBody modal_body(const std::string &name, const ModalDefinition &definition, ModalData data);

/// The same with the data of the file that the definition names.
ReducedBody modal_body_from_file(const std::string &name, const ModalDefinition &definition);

} // namespace vibroimpact::reduction
