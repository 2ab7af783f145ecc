//! CAN-ID → service.

use std::collections::HashMap;

use lexican_runtime::{Address, NodeId, wire::CanId};

use super::{Direction, node::Node};

const COB_ID_SYNC: Address = Address::new(0x1005, 0);
const COB_ID_TIME: Address = Address::new(0x1012, 0);
const COB_ID_EMCY: Address = Address::new(0x1014, 0);

/// What a frame is for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Route {
    #[default]
    None,
    Nmt,
    Sync,
    Time,
    LssRequest,
    LssResponse,
    ErrorControl(NodeId),
    Emergency(NodeId),
    SdoRequest {
        node: NodeId,
        /// From 0.
        server: u8,
    },
    SdoResponse {
        node: NodeId,
        /// From 0.
        server: u8,
    },
    Pdo {
        node: NodeId,
        /// Among the node's PDOs.
        at: u16,
    },
}

/// The services of all nodes.
#[derive(Debug)]
pub(super) struct Routes {
    /// By identifier of 11 bits.
    standard: Vec<Route>,
    extended: HashMap<CanId, Route>,
}

impl Route {
    /// The node that a frame with this identifier shows to be there by the pre-defined connection set, if nothing is known of
    /// it yet.
    pub(super) fn stranger(self, id: CanId, is_known: impl Fn(NodeId) -> bool) -> Option<NodeId> {
        let node_id = match self {
            Self::ErrorControl(node)
            | Self::Emergency(node)
            | Self::SdoRequest { node, .. }
            | Self::SdoResponse { node, .. } => node,
            Self::None if !id.is_extended() && (0x181..=0x57F).contains(&id.number()) => {
                NodeId::new(u8::try_from(id.number() & 0x7F).ok()?)?
            }
            _ => return None,
        };
        (!is_known(node_id)).then_some(node_id)
    }

    /// Of which node it is.
    const fn node(self) -> Option<NodeId> {
        match self {
            Self::ErrorControl(node)
            | Self::Emergency(node)
            | Self::SdoRequest { node, .. }
            | Self::SdoResponse { node, .. }
            | Self::Pdo { node, .. } => Some(node),
            _ => None,
        }
    }
}

impl Routes {
    /// The pre-defined connection set.
    pub(super) fn new() -> Self {
        let mut routes = Self {
            standard: vec![Route::None; 0x800],
            extended: HashMap::new(),
        };
        routes.put(CanId::NMT, Route::Nmt);
        routes.put(CanId::LSS_REQUEST, Route::LssRequest);
        routes.put(CanId::LSS_RESPONSE, Route::LssResponse);
        routes.put_if_free(CanId::standard(0x080), Route::Sync);
        routes.put_if_free(CanId::standard(0x100), Route::Time);
        for node in (1..=127).filter_map(NodeId::new) {
            routes.put_predefined(node);
            routes.put_if_free(CanId::standard(0x080 + u32::from(node.get())), Route::Emergency(node));
        }
        routes
    }

    pub(super) fn find(&self, id: CanId) -> Route {
        if id.is_extended() {
            return self.extended.get(&id).copied().unwrap_or_default();
        }
        let place = usize::try_from(id.number()).unwrap_or(usize::MAX);
        self.standard.get(place).copied().unwrap_or_default()
    }

    /// Puts what `node` says of itself in the place of what was known of it.
    pub(super) fn replace(&mut self, node: &Node<'_>) {
        let is_of_node = |route: &Route| route.node() == Some(node.id);
        self.standard
            .iter_mut()
            .filter(|route| is_of_node(route))
            .for_each(|route| *route = Route::None);
        self.extended.retain(|_, route| !is_of_node(route));
        self.put_predefined(node.id);
        self.put_servers(node);
        self.put_emergency(node);
        self.put_if_free(node.any_can_id(COB_ID_SYNC), Route::Sync);
        self.put_if_free(node.any_can_id(COB_ID_TIME), Route::Time);
        self.put_pdos(node);
    }

    fn put_predefined(&mut self, node: NodeId) {
        self.put(CanId::sdo_request(node), Route::SdoRequest { node, server: 0 });
        self.put(CanId::sdo_response(node), Route::SdoResponse { node, server: 0 });
        self.put(CanId::error_control(node), Route::ErrorControl(node));
    }

    fn put_servers(&mut self, node: &Node<'_>) {
        for server in 1..=0x7F {
            let index = 0x1200 + u16::from(server);
            let node_id = node.id;
            let (request, response) = (node.can_id(Address::new(index, 1)), node.can_id(Address::new(index, 2)));
            self.put_if_free(request, Route::SdoRequest { node: node_id, server });
            self.put_if_free(response, Route::SdoResponse { node: node_id, server });
        }
    }

    fn put_emergency(&mut self, node: &Node<'_>) {
        let id = if node.configures(COB_ID_EMCY) {
            node.can_id(COB_ID_EMCY)
        } else {
            CanId::standard(0x080 + u32::from(node.id.get()))
        };
        self.put_if_free(id, Route::Emergency(node.id));
    }

    /// The producer of a PDO knows best what is in it: its TPDO stands before the RPDO of who listens to it.
    fn put_pdos(&mut self, node: &Node<'_>) {
        for (at, pdo) in (0..).zip(&node.pdos) {
            let route = Route::Pdo { node: node.id, at };
            let id = pdo.can_id;
            match (pdo.direction, id) {
                (Direction::Transmit, Some(id)) if matches!(self.find(id), Route::Pdo { .. }) => self.put(id, route),
                _ => self.put_if_free(id, route),
            }
        }
    }

    fn put_if_free(&mut self, id: Option<CanId>, route: Route) {
        if let Some(id) = id.filter(|id| self.find(*id) == Route::None) {
            self.put(id, route);
        }
    }

    fn put(&mut self, id: CanId, route: Route) {
        if id.is_extended() {
            self.extended.insert(id, route);
            return;
        }
        let place = usize::try_from(id.number()).unwrap_or(usize::MAX);
        if let Some(place) = self.standard.get_mut(place) {
            *place = route;
        }
    }
}
